using Msisf.Adapters.Tiles;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles;

namespace Msisf.Stress.Povray;

/// <summary>
/// A square of a tile's cells, with the tile's own vertices and origin: what POV-Ray makes of a triangle does not depend on the others, and
/// a whole tile of 1024 px/deg has 52 million.
/// </summary>
internal sealed class TraceBlock
{
    private const double MetresPerKilometre = 1000.0;

    /// <summary>1, part of a facet: a ray this close to an edge could as well hit the neighbour.</summary>
    private const double EdgeMargin = 0.01;

    /// <summary>Of the angle between ray and normal: grazing rays go over to other facets for reasons of their own.</summary>
    private const double MinCosine = 0.05;

    private const double MinDistanceKm = 0.01;

    /// <summary>To the Earth.</summary>
    private const double MaxDistanceKm = 4e5;

    private readonly TileMesh _mesh;
    private readonly string _productId;
    private readonly Vector3D[] _verticesKm;
    private readonly Vector3D _originKm;

    /// <param name="builder">Of the grid.</param>
    /// <param name="grid">The model.</param>
    /// <param name="layout">The block.</param>
    public TraceBlock(TileMeshBuilder builder, IGlobalGrid grid, TileMeshLayout layout)
    {
        _mesh = builder.Build(layout, builder.ReadRadii(layout));
        _productId = grid.ProductId;
        _verticesKm = [.. Enumerable.Range(0, layout.VertexCount).Select(
            vertex => _mesh.Vertex(vertex).PositionBodyFixed / MetresPerKilometre)];
        _originKm = _mesh.Origin.PositionBodyFixed / MetresPerKilometre;
    }

    /// <summary>A block of a tile: at the corner farthest from the tile's origin, or anywhere.</summary>
    /// <param name="tile">The tile.</param>
    /// <param name="pixelsPerDegree">Resolution.</param>
    /// <param name="mostCells">Cells along a side at most.</param>
    /// <param name="random">Draws the place.</param>
    public static TileMeshLayout Layout(TileId tile, int pixelsPerDegree, int mostCells, CaseRandom random)
    {
        TileMeshLayout whole = TileMeshLayout.For(tile, pixelsPerDegree);
        int lines = Math.Min(mostCells + 1, whole.Lines);
        int samples = Math.Min(mostCells + 1, whole.Samples);
        bool isAtCorner = random.Below(2) == 0;
        int down = isAtCorner ? random.Below(2) * (whole.Lines - lines) : random.Below(whole.Lines - lines + 1);
        int right = isAtCorner ? random.Below(2) * (whole.Samples - samples) : random.Below(whole.Samples - samples + 1);
        return whole with
        {
            FirstLine = whole.FirstLine + down,
            Lines = lines,
            FirstSample = (whole.FirstSample + right) % (360 * pixelsPerDegree),
            Samples = samples,
        };
    }

    /// <summary>Where it is, for the report.</summary>
    public string Place =>
        $"{_mesh.Layout.PixelsPerDegree} px/deg, {_mesh.Layout.Tile.RangeText}, cells from line {_mesh.Layout.FirstLine}, "
            + $"sample {_mesh.Layout.FirstSample} on";

    /// <summary>Writes it as a pattern.</summary>
    public void Write(string path, PatternFormat format)
    {
        using FileStream stream = File.Create(path);
        PatternWriter.Write(stream, _mesh, _productId, format);
    }

    /// <summary>A ray that starts 10 m to 4e8 m away and meets the inside of a facet.</summary>
    public TraceRay Draw(CaseRandom random)
    {
        while (true)
        {
            (Vector3D a, Vector3D b, Vector3D c) = Corners(random.Below(_mesh.Layout.FaceCount));
            double along = Math.Sqrt(random.Unit());
            double across = along * random.Unit();
            Vector3D target = a + ((along - across) * (b - a)) + (across * (c - a));
            Vector3D normal = Vector3D.Cross(b - a, c - a).Normalized();
            Vector3D outward = random.Direction();
            double cosine = Vector3D.Dot(outward, normal);
            if (Math.Abs(cosine) < MinCosine)
            {
                continue;
            }

            outward = Math.Sign(cosine) * outward;
            Vector3D start = target + (random.Logarithmic(MinDistanceKm, MaxDistanceKm) * outward);
            if (FirstHit(start, -outward) is TraceRay ray && ray.Cosine >= MinCosine)
            {
                return ray;
            }
        }
    }

    private (Vector3D A, Vector3D B, Vector3D C) Corners(int face) => (
        _verticesKm[_mesh.Faces[3 * face]], _verticesKm[_mesh.Faces[(3 * face) + 1]], _verticesKm[_mesh.Faces[(3 * face) + 2]]);

    /// <summary>
    /// Each facet, by T. Moeller, B. Trumbore, J. Graphics Tools 2 (1997) 21, both sides; null if the ray comes near an edge first. To
    /// 1e-10 km.
    /// </summary>
    private TraceRay? FirstHit(Vector3D startKm, Vector3D direction)
    {
        double first = double.PositiveInfinity;
        (double AtB, double AtC) inside = default;
        int facet = -1;
        for (int face = 0; face < _mesh.Layout.FaceCount; face++)
        {
            (Vector3D a, Vector3D b, Vector3D c) = Corners(face);
            (Vector3D ab, Vector3D ac, Vector3D fromA) = (b - a, c - a, startKm - a);
            Vector3D p = Cross(direction, ac);
            double determinant = Vector3D.Dot(ab, p);
            double u = Vector3D.Dot(fromA, p) / determinant;
            Vector3D q = Cross(fromA, ab);
            double v = Vector3D.Dot(direction, q) / determinant;
            double t = Vector3D.Dot(ac, q) / determinant;
            double margin = Math.Min(Math.Min(u, v), 1.0 - u - v);
            if (margin > -EdgeMargin && t > 0.0 && t < first)
            {
                (first, inside, facet) = (t, (u, v), face);
            }
        }

        double insideA = 1.0 - inside.AtB - inside.AtC;
        if (facet < 0 || Math.Min(insideA, Math.Min(inside.AtB, inside.AtC)) < EdgeMargin)
        {
            return null;
        }

        (Vector3D cornerA, Vector3D cornerB, Vector3D cornerC) = Corners(facet);
        Vector3D across = Vector3D.Cross(cornerB - cornerA, cornerC - cornerA);
        Vector3D normal = across.Normalized();
        Vector3D hit = startKm - (Vector3D.Dot(startKm - cornerA, normal) / Vector3D.Dot(direction, normal) * direction);

        // A corner's share of the facet's doubled area, divided by the opposite edge, is the distance from that edge.
        double edge = across.Length * Math.Min(
            insideA / (cornerC - cornerB).Length,
            Math.Min(inside.AtB / (cornerC - cornerA).Length, inside.AtC / (cornerB - cornerA).Length));
        return new TraceRay(startKm, direction, hit, normal, edge, _originKm);
    }

    /// <summary>Plain: millions are needed, and a facet's size is all that they lose digits by.</summary>
    private static Vector3D Cross(Vector3D u, Vector3D v) =>
        new((u.Y * v.Z) - (u.Z * v.Y), (u.Z * v.X) - (u.X * v.Z), (u.X * v.Y) - (u.Y * v.X));
}
