namespace Msisf.Core.Render.Shadows;

/// <summary>Planes across the Sun's rays, at equal distances, and columns along u in each of them.</summary>
/// <remarks>
/// A plane is numbered by its depth and a column by its bounds of v. Heights in a plane are values of u, relative to
/// <see cref="BaseU"/> so that they fit into floats.
/// </remarks>
internal sealed class SectionGrid
{
    /// <summary>Maximum number of planes; with <see cref="MaxColumns"/> it limits a table of heights to 1 MB.</summary>
    private const int MaxPlanes = 512;

    /// <summary>Maximum number of columns.</summary>
    private const int MaxColumns = 512;

    private readonly LightAxis _columns;

    /// <summary>Divides a part of light space.</summary>
    /// <param name="receivers">Bounds of the receivers across the rays, m; not empty.</param>
    /// <param name="minDepth">Depth of the first plane, m.</param>
    /// <param name="maxDepth">Depth that no plane exceeds, m.</param>
    /// <param name="spacing">Minimum distance between two planes, m.</param>
    /// <param name="slope">Radius of the Sun's disc over its distance.</param>
    public SectionGrid(in LightBox receivers, double minDepth, double maxDepth, double spacing, double slope)
    {
        double range = maxDepth - minDepth;
        BaseU = receivers.MinU;
        MinDepth = minDepth;
        Spacing = Math.Max(spacing, range / (MaxPlanes - 1));
        Planes = (int)(range / Spacing) + 1;

        // A column is wide enough that a ray to the disc's rim crosses into the next column only, from one plane to the next.
        double width = receivers.MaxV - receivers.MinV;
        Columns = (int)Math.Clamp(width / Math.Max(slope * Spacing, width / MaxColumns), 1.0, MaxColumns);
        ColumnWidth = width / Columns;
        MinV = receivers.MinV;
        MaxV = receivers.MaxV;
        _columns = new LightAxis(MinV, MaxV, Columns);
    }

    public int Planes { get; }

    public int Columns { get; }

    /// <summary>Distance between two planes, m.</summary>
    public double Spacing { get; }

    /// <summary>Width of a column, m.</summary>
    public double ColumnWidth { get; }

    /// <summary>The u, m, from which heights count.</summary>
    public double BaseU { get; }

    /// <summary>Depth of the first plane, m.</summary>
    public double MinDepth { get; }

    /// <summary>Minimum v of the first column, m.</summary>
    public double MinV { get; }

    /// <summary>Maximum v of the last column, m.</summary>
    public double MaxV { get; }

    /// <summary>Depth of a plane, m.</summary>
    public double DepthOf(int plane) => MinDepth + (plane * Spacing);

    /// <summary>The last plane that is not deeper than a depth, m; -1 if there is none.</summary>
    public int PlaneAt(double depth) => (int)Math.Clamp(Math.Floor((depth - MinDepth) / Spacing), -1.0, Planes - 1.0);

    /// <summary>The column of a v, m; those outside belong to the first and the last column.</summary>
    public int ColumnOf(double v) => _columns.BinOf(v);

    /// <summary>Minimum v of a column, m, up to rounding errors.</summary>
    public double StartOf(int column) => _columns.StartOf(column);
}
