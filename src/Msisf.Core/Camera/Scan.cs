namespace Msisf.Core.Camera;

/// <summary>How a camera makes one image by many exposures.</summary>
public enum ScanKind
{
    /// <summary>One row of pixels, exposed again and again: each exposure is a line of the image.</summary>
    LineScan,

    /// <summary>Some rows, exposed again and again: the framelets lie in the image one below the other.</summary>
    PushFrame,

    /// <summary>A whole image whose rows are exposed one after the other, from the top.</summary>
    RollingShutter,
}

/// <summary>
/// An image by many exposures at equal intervals, each with a state of its own (docs/scanning-cameras.md). The image's time is the middle
/// of the first exposure. Immutable.
/// </summary>
/// <param name="Kind">What an exposure adds to the image.</param>
/// <param name="Count">Number of exposures: lines, framelets or rows; at least 1.</param>
/// <param name="Period">s from one exposure to the next, above 0.</param>
public sealed record Scan(ScanKind Kind, int Count, double Period)
{
    /// <summary>
    /// Rows of the detector whose electrons a line adds up while they move with the image (TDI); 1 for a line of its own. The camera has
    /// as many rows.
    /// </summary>
    public int Stages { get; init; } = 1;

    /// <summary>Whether the electrons of TDI move to rows further down; otherwise up.</summary>
    public bool ChargeMovesDown { get; init; } = true;

    /// <summary>Rows of the detector that a framelet has; null for all.</summary>
    public PixelRows? Framelet { get; init; }

    /// <summary>Whether the first exposure is the lowest of the image; otherwise it is the topmost.</summary>
    public bool GrowsUpwards { get; init; }

    /// <summary>Whether the rows of each framelet are read from the lowest to the topmost.</summary>
    public bool FlipsFramelets { get; init; }

    /// <summary>px: height of the image.</summary>
    public int HeightOf(CameraModel model) => Count * (Kind == ScanKind.PushFrame ? RowsOf(model).End - RowsOf(model).First : 1);

    /// <summary>s after the image's time: the middle of an exposure.</summary>
    /// <param name="exposure">From 0.</param>
    public double SecondsOf(int exposure) => exposure * Period;

    /// <summary>The camera of the whole image.</summary>
    /// <param name="states">State of each exposure.</param>
    public ICamera CameraOf(CameraModel model, IReadOnlyList<CameraState> states)
    {
        ArgumentOutOfRangeException.ThrowIfNotEqual(states.Count, Count);
        if (Kind == ScanKind.RollingShutter)
        {
            return BandedCamera.Of(model, states);
        }

        CameraModel[] shown = Kind == ScanKind.LineScan ? [LineOf(model, 0.0)] : [.. FrameletsOf(model)];
        IEnumerable<int> order = GrowsUpwards ? Enumerable.Range(0, Count).Reverse() : Enumerable.Range(0, Count);
        return BandedCamera.Of([.. order.SelectMany(exposure => shown.Select(part => part.At(states[exposure])))]);
    }

    /// <summary>The camera of one exposure, all of its rows in the detector's order.</summary>
    /// <param name="exposure">From 0.</param>
    /// <param name="rowsBelow">px: how far below its place a stage of TDI lies; 0 for others.</param>
    public CameraModel ExposureOf(CameraModel model, int exposure, double rowsBelow) => Kind switch
    {
        ScanKind.LineScan => LineOf(model, rowsBelow),
        ScanKind.PushFrame => model.Window(0, RowsOf(model).First, model.Width, RowsOf(model).End - RowsOf(model).First),
        _ => model.Window(0, exposure, model.Width, 1),
    };

    /// <summary>Rows of the detector that an exposure lies on: one row of the image for a rolling shutter, otherwise all.</summary>
    /// <inheritdoc cref="ExposureOf"/>
    public PixelRows DetectorRowsOf(CameraModel model, int exposure) => Kind == ScanKind.RollingShutter
        ? new PixelRows(exposure, exposure + 1)
        : new PixelRows(0, HeightOf(model) / Count);

    /// <summary>The row of the image, from 0, that shows a row of an exposure.</summary>
    /// <param name="exposure">From 0.</param>
    /// <param name="row">Row of the exposure, from 0.</param>
    public int ImageRowOf(CameraModel model, int exposure, int row)
    {
        int rows = HeightOf(model) / Count;
        return ((GrowsUpwards ? Count - 1 - exposure : exposure) * rows) + (FlipsFramelets ? rows - 1 - row : row);
    }

    /// <summary>The camera of a line: that of the middle of the detector's rows, or as far below it as its stage lies.</summary>
    /// <param name="model">The camera, which has a row for each stage.</param>
    /// <param name="rowsBelow">px.</param>
    public static CameraModel LineOf(CameraModel model, double rowsBelow) => model.Height == 1 && rowsBelow == 0.0
        ? model
        : new CameraModel(
            model.Width, 1, (model.FocalX, model.FocalY),
            (model.PrincipalX, model.PrincipalY - (0.5 * (model.Height - 1)) - rowsBelow), model.Skew, model.Distortion).Simplified();

    /// <summary>px below the middle of the detector's rows, and s after the line's time: where and when a stage of TDI is
    /// exposed.</summary>
    /// <param name="stage">From 0 to below <see cref="Stages"/>.</param>
    public (double RowsBelow, double Seconds) Stage(int stage)
    {
        double steps = stage - (0.5 * (Stages - 1));
        return (ChargeMovesDown ? steps : -steps, steps * Period);
    }

    private PixelRows RowsOf(CameraModel model) => Framelet ?? new PixelRows(0, model.Height);

    private IEnumerable<CameraModel> FrameletsOf(CameraModel model)
    {
        (int first, int end) = RowsOf(model);
        return FlipsFramelets
            ? Enumerable.Range(first, end - first).Reverse().Select(row => model.Window(0, row, model.Width, 1))
            : [model.Window(0, first, model.Width, end - first)];
    }
}
