using Msisf.Core.Numerics;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;

namespace Msisf.Core.Tests.Support;

/// <summary>Every facet of a surface of several models, and rays against each of them, by Moeller and Trumbore.</summary>
internal sealed class AllFacets
{
    private const double EdgeTolerance = 1e-11;

    /// <summary>Facets that follow each other lie side by side: a ray that misses the ball around so many misses them all.</summary>
    private const int FacetsOfBall = 32;

    /// <summary>Balls that follow each other, in a larger ball.</summary>
    private const int BallsOfBall = 8;

    /// <summary>1, of a ball's radius: far more than a facet is missed by where the ray is nearly in its plane.</summary>
    private const double BallMargin = 1.01;

    private readonly (FacetId Facet, Vector3D A, Vector3D B, Vector3D C)[] _facets;
    private readonly Lazy<List<Ball[]>> _balls;

    public AllFacets(ITerrain terrain)
        : this(Collect(terrain))
    {
    }

    private AllFacets((FacetId Facet, Vector3D A, Vector3D B, Vector3D C)[] facets)
    {
        _facets = facets;
        _balls = new(BallsAround);
    }

    /// <summary>The facets with their corners, m, counter-clockwise seen from outside.</summary>
    public IReadOnlyList<(FacetId Facet, Vector3D A, Vector3D B, Vector3D C)> Facets => _facets;

    /// <summary>Those facets of which a condition holds.</summary>
    public AllFacets Where(Func<(FacetId Facet, Vector3D A, Vector3D B, Vector3D C), bool> isThere) => new([.. Facets.Where(isThere)]);

    /// <summary>
    /// What keeps the facets from being one closed surface, or null. Closed: each edge is run through once in each direction. In one piece
    /// that goes once around the Moon: its Euler characteristic is 2.
    /// </summary>
    public string? FindFlaw()
    {
        Dictionary<Vector3D, uint> vertices = [];
        HashSet<(uint From, uint To)> edges = new(3 * Facets.Count);
        foreach ((FacetId facet, Vector3D a, Vector3D b, Vector3D c) in Facets)
        {
            (uint first, uint second, uint third) = (NumberOf(a), NumberOf(b), NumberOf(c));
            if (!edges.Add((first, second)) || !edges.Add((second, third)) || !edges.Add((third, first)))
            {
                return $"{facet}: an edge of it is one of another facet too.";
            }
        }

        int open = edges.Count(edge => !edges.Contains((edge.To, edge.From)));
        int characteristic = vertices.Count - (edges.Count / 2) + Facets.Count;
        return open > 0 ? $"{open} edges have one facet only."
            : characteristic != 2 ? $"The Euler characteristic is {characteristic}."
            : null;

        uint NumberOf(Vector3D vertex)
        {
            uint number = (uint)vertices.Count;
            return vertices.TryAdd(vertex, number) ? number : vertices[vertex];
        }
    }

    /// <summary>The first facet that a ray enters from outside, not counting hits before so many lengths of the direction.</summary>
    public (FacetId Facet, Vector3D Point, double T)? FirstHit(Vector3D origin, Vector3D direction, double minT = 0.0)
    {
        (FacetId Facet, Vector3D Point, double T)? best = null;
        int top = _balls.Value.Count - 1;
        for (int ball = 0; ball < _balls.Value[top].Length; ball++)
        {
            HitFirstIn(top, ball, origin, direction, minT, ref best);
        }

        return best;
    }

    /// <summary>Whether the way from a point on a facet to the light enters another facet.</summary>
    public bool IsShadowed(FacetId facet, Vector3D point, Vector3D light)
    {
        Vector3D toLight = light - point;
        return FirstHit(point, toLight, 1e-4 / toLight.Length) is (FacetId hit, _, double t) && t < 1.0 && hit != facet;
    }

    private static (FacetId Facet, Vector3D A, Vector3D B, Vector3D C)[] Collect(ITerrain terrain)
    {
        SurfaceModel surface = SurfaceModel.Of(terrain);
        List<(FacetId, Vector3D, Vector3D, Vector3D)> all = [];
        for (int part = 0; part < surface.Parts.Count; part++)
        {
            CellRange cells = surface.Parts[part].Mesh.Cells;
            for (int line = cells.FirstLine; line < cells.EndLine; line++)
            {
                for (int sample = cells.FirstSample; sample < cells.EndSample; sample++)
                {
                    foreach (FacetHalf half in new[] { FacetHalf.SouthWest, FacetHalf.NorthEast })
                    {
                        Add(new FacetId(line, sample, half) { Part = part });
                    }
                }
            }
        }

        for (int seam = 0; seam < surface.Seams.Count; seam++)
        {
            Add(new FacetId(0, seam, FacetHalf.SouthWest) { Part = surface.Parts.Count });
        }

        return [.. all];

        void Add(FacetId facet)
        {
            if (surface.Has(facet))
            {
                (Vector3D a, Vector3D b, Vector3D c) = surface.CornersOf(facet);
                if (a != b && b != c && c != a) // at a pole a cell has one facet
                {
                    all.Add((facet, a, b, c));
                }
            }
        }
    }

    /// <summary>Balls around the facets, then balls around those of the level before.</summary>
    private List<Ball[]> BallsAround()
    {
        List<Ball[]> levels = [[.. _facets.Chunk(FacetsOfBall).Select(Ball.Around)]];
        while (levels[^1].Length > BallsOfBall)
        {
            levels.Add([.. levels[^1].Chunk(BallsOfBall).Select(Ball.Around)]);
        }

        return levels;
    }

    private void HitFirstIn(
        int level, int ball, Vector3D origin, Vector3D direction, double minT, ref (FacetId Facet, Vector3D Point, double T)? best)
    {
        if (_balls.Value[level][ball].IsMissedBy(origin, direction))
        {
            return;
        }

        if (level == 0)
        {
            int start = ball * FacetsOfBall;
            HitFirstOf(_facets.AsSpan(start, Math.Min(FacetsOfBall, _facets.Length - start)), origin, direction, minT, ref best);
            return;
        }

        int first = ball * BallsOfBall;
        for (int inner = first; inner < Math.Min(first + BallsOfBall, _balls.Value[level - 1].Length); inner++)
        {
            HitFirstIn(level - 1, inner, origin, direction, minT, ref best);
        }
    }

    private static void HitFirstOf(
        ReadOnlySpan<(FacetId Facet, Vector3D A, Vector3D B, Vector3D C)> facets, Vector3D origin, Vector3D direction, double minT,
        ref (FacetId Facet, Vector3D Point, double T)? best)
    {
        foreach ((FacetId facet, Vector3D a, Vector3D b, Vector3D c) in facets)
        {
            Vector3D ab = b - a;
            Vector3D ac = c - a;
            Vector3D p = Vector3D.Cross(direction, ac);
            double determinant = Vector3D.Dot(ab, p);
            if (!(determinant > 0.0))
            {
                continue; // from below, or edge on
            }

            Vector3D fromA = origin - a;
            double u = Vector3D.Dot(fromA, p);
            if (u < -EdgeTolerance * determinant || u > (1.0 + EdgeTolerance) * determinant)
            {
                continue;
            }

            Vector3D q = Vector3D.Cross(fromA, ab);
            double v = Vector3D.Dot(direction, q);
            double t = Vector3D.Dot(ac, q) / determinant;
            if (v >= -EdgeTolerance * determinant && u + v <= (1.0 + EdgeTolerance) * determinant && t >= minT && !(t >= best?.T))
            {
                best = (facet, origin + (t * direction), t);
            }
        }
    }

    /// <param name="Middle">m.</param>
    /// <param name="Radius">m.</param>
    private readonly record struct Ball(Vector3D Middle, double Radius)
    {
        public static Ball Around((FacetId Facet, Vector3D A, Vector3D B, Vector3D C)[] facets)
        {
            Vector3D sum = default;
            foreach ((_, Vector3D a, Vector3D b, Vector3D c) in facets)
            {
                sum += a + b + c;
            }

            Vector3D middle = sum / (3 * facets.Length);
            double largest = 0.0;
            foreach ((_, Vector3D a, Vector3D b, Vector3D c) in facets)
            {
                largest = Math.Max(largest, Math.Max((a - middle).LengthSquared, (b - middle).LengthSquared));
                largest = Math.Max(largest, (c - middle).LengthSquared);
            }

            return new Ball(middle, BallMargin * Math.Sqrt(largest));
        }

        public static Ball Around(Ball[] balls)
        {
            Vector3D middle = balls.Aggregate(default(Vector3D), (sum, ball) => sum + ball.Middle) / balls.Length;
            return new Ball(middle, balls.Max(ball => (ball.Middle - middle).Length + ball.Radius));
        }

        public bool IsMissedBy(Vector3D origin, Vector3D direction) =>
            Vector3D.Cross(Middle - origin, direction).LengthSquared > Radius * Radius * direction.LengthSquared;
    }
}
