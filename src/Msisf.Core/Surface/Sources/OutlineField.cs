using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// The height that a model gets near the outlines of finer ones, so that it meets them: at an outline the difference there, farther away
/// less, and nothing beyond the reach. Immutable.
/// </summary>
/// <remarks>
/// r is the distance from a place to the nearest outline, c the width of the model's cells, and m the mean of the differences on the
/// outlines within R = 2 r + c / 2, with weights (1 - (distance / R)^2)^2. The height is m (1 - t)^2 (1 + 2 t), with t = r / w, and
/// w = max(2 c, 1.5 |m| / tan(0.5 degrees)). Distances are chords of the reference sphere, so that poles are places as all others. The
/// slope of (1 - t)^2 (1 + 2 t) is 1.5 / w at most.
/// </remarks>
internal sealed class OutlineField
{
    /// <summary>
    /// Tangent of half a degree: the greatest slope by which a difference dies away. The Sun's disc is 0.53 degrees wide, so that such a
    /// slope moves the edge of a shadow by less than its own penumbra.
    /// </summary>
    public const double MaxSlope = 0.0087268677907587;

    /// <summary>Cells of the model over which a difference is carried at least: fewer could not show that it dies away smoothly.</summary>
    public const double LeastCells = 2.0;

    /// <summary>Parts of a cell into which outlines are divided: half of the least distance of a cell from an outline, and less.</summary>
    private const double PartsOfCell = 4.0;

    /// <summary>Divisions of R: a mean over longer pieces would differ by some thousandths of what the differences differ by.</summary>
    private const double PiecesOfReach = 8.0;

    private readonly double _cell;
    private readonly double _finest;
    private readonly OutlinePiece _top;

    /// <summary>Takes the differences.</summary>
    /// <param name="differences">At least one; the order decides about rounding only.</param>
    /// <param name="cell">m: width of the cells of the model.</param>
    public OutlineField(IReadOnlyList<OutlineDifference> differences, double cell)
    {
        _cell = cell;
        _finest = PieceOf(cell);
        (_top, IReadOnlyList<double> greatest) = OutlinePiece.TreeOf(differences, _finest);
        Limits = (Math.Min(0.0, differences.Min(one => one.Height)), Math.Max(0.0, differences.Max(one => one.Height)));
        Reach = LeastCells * cell;
        for (int level = 0; level < greatest.Count; level++)
        {
            // The means at such distances are of pieces of this level.
            double least = level == 0 ? 0.0 : 0.5 * ((PiecesOfReach * Math.ScaleB(_finest, level)) - (0.5 * cell));
            double most = level == greatest.Count - 1
                ? double.PositiveInfinity
                : 0.5 * ((PiecesOfReach * Math.ScaleB(_finest, level + 1)) - (0.5 * cell));
            double width = WidthOf(greatest[level], cell);
            Reach = width > least ? Math.Max(Reach, Math.Min(width, most)) : Reach;
        }
    }

    /// <summary>m: least and greatest height that any place gets.</summary>
    public (double Min, double Max) Limits { get; }

    /// <summary>m: places farther from all outlines get nothing.</summary>
    public double Reach { get; }

    /// <summary>m: how far from an outline a difference dies away.</summary>
    /// <param name="difference">m: its absolute value.</param>
    /// <param name="cell">m: width of the model's cells.</param>
    public static double WidthOf(double difference, double cell) => Math.Max(LeastCells * cell, 1.5 * difference / MaxSlope);

    /// <summary>Size of the pieces of an outline that a model with cells of a width distinguishes, m.</summary>
    public static double PieceOf(double cell) => cell / PartsOfCell;

    /// <summary>m: distance of a direction from the nearest outline; null if that is farther than the reach and some more.</summary>
    /// <param name="direction">Unit vector, body-fixed.</param>
    /// <param name="more">m.</param>
    public double? DistanceOf(Vector3D direction, double more)
    {
        double nearest = Reach + more;
        return _top.FindNearest(MoonConstants.ReferenceRadius * direction, ref nearest) ? nearest : null;
    }

    /// <summary>m: the height that a place gets.</summary>
    /// <param name="direction">Unit vector, body-fixed.</param>
    /// <param name="within">m: the nearest outline is not farther away than this, which saves time.</param>
    public double At(Vector3D direction, double within = double.PositiveInfinity)
    {
        Vector3D place = MoonConstants.ReferenceRadius * direction;
        double distance = Math.Min(Reach, within);
        if (!_top.FindNearest(place, ref distance))
        {
            return 0.0;
        }

        double around = (2.0 * distance) + (0.5 * _cell);
        OutlineMean mean = default;
        _top.AddTo(ref mean, place, around, Math.Max(_finest, around / PiecesOfReach));
        double height = mean.Height / mean.Weight;
        double t = distance / WidthOf(Math.Abs(height), _cell);
        return t < 1.0 ? height * (1.0 - t) * (1.0 - t) * (1.0 + (2.0 * t)) : 0.0;
    }

}

/// <summary>How much higher a model is than the ground of a coarser one, at a sample of its outline.</summary>
/// <param name="Place">The sample's place on the reference sphere, m, body-fixed.</param>
/// <param name="Height">m: the finer model's height less that of the coarser one.</param>
/// <param name="Length">m of the outline for which the sample is.</param>
internal readonly record struct OutlineDifference(Vector3D Place, double Height, double Length);
