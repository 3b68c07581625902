namespace Msisf.Core.Surface;

/// <summary>Bounds of a block of facets of the seams.</summary>
/// <param name="Box">Cap of directions, and box.</param>
/// <param name="Node">Cap and radii; slopes are not known.</param>
/// <param name="Ball">A ball that contains the facets: centre, m, body-fixed, and radius, m.</param>
internal readonly record struct SeamBlock(NodeBox Box, TerrainNode Node, (Vector3D Centre, double Radius) Ball)
{
    /// <summary>Finds the bounds of facets.</summary>
    /// <param name="corners">Their corners, m, body-fixed.</param>
    public static SeamBlock Of(ReadOnlySpan<Vector3D> corners)
    {
        Vector3D sum = default;
        foreach (Vector3D corner in corners)
        {
            sum += corner;
        }

        // A facet is seen at a cap's angle at most if its corners are, and none of its points lies nearer than the plane across the cap's
        // axis through its nearest corner.
        Vector3D up = sum.Normalized();
        Vector3D across = Vector3D.Cross(up, Math.Abs(up.Z) < 0.5 ? Vector3D.UnitZ : Vector3D.UnitX).Normalized();
        Vector3D along = Vector3D.Cross(up, across);
        double angle = 0.0;
        double highest = 0.0;
        (Vector3D low, Vector3D high) = (new(1e300, 1e300, 1e300), new(-1e300, -1e300, -1e300));
        foreach (Vector3D corner in corners)
        {
            angle = Math.Max(angle, Vector3D.AngleBetween(up, corner));
            highest = Math.Max(highest, corner.Length);
            Vector3D at = new(Vector3D.Dot(corner, up), Vector3D.Dot(corner, across), Vector3D.Dot(corner, along));
            low = new Vector3D(Math.Min(low.X, at.X), Math.Min(low.Y, at.Y), Math.Min(low.Z, at.Z));
            high = new Vector3D(Math.Max(high.X, at.X), Math.Max(high.Y, at.Y), Math.Max(high.Z, at.Z));
        }

        const double Margin = Tolerances.VertexLattice;
        Vector3D middle = 0.5 * (low + high);
        Vector3D half = (0.5 * (high - low)) + new Vector3D(Margin, Margin, Margin);
        Vector3D centre = (middle.X * up) + (middle.Y * across) + (middle.Z * along);
        (double sine, double cosine) = Math.SinCos(angle + Tolerances.CapRadius);
        return new SeamBlock(
            new NodeBox(up, new SineCosine(sine, cosine), new OrientedBox(centre, half.X * up, half.Y * across, half.Z * along)),
            new TerrainNode(new SphericalCap(up, cosine, sine), low.X - Margin, highest + Margin, double.PositiveInfinity),
            (centre, half.Length));
    }
}

/// <summary>A vertex of a model that a seam uses too.</summary>
/// <param name="Position">m, body-fixed, on the lattice of its model.</param>
/// <param name="Line">Line of the vertex in the model's mesh.</param>
internal readonly record struct SeamVertex(Vector3D Position, int Part, int Line, int Sample);
