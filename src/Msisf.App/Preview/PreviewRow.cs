using Msisf.Core.Preview;
using Msisf.Core.Terrain;
using Msisf.Core.Time;

namespace Msisf.App.Preview;

/// <summary>What one image will show: a line of the table of <c>--dry-run</c>.</summary>
/// <param name="Step">Number of the frame, from 1, in the order of the input.</param>
/// <param name="Time">Time, UTC.</param>
/// <param name="HeightOverGround">Height of the camera over the terrain, m; over the reference sphere if there is no model.</param>
/// <param name="View">What the image will show.</param>
/// <param name="PixelsPerCell">Width of a cell of the model in the middle of the image, px; null if that shows no ground.</param>
internal sealed record PreviewRow(int Step, ModifiedJulianDate Time, double HeightOverGround, FramePreview View, double? PixelsPerCell)
{
    /// <summary>
    /// Of several models the resolution at which each would be drawn, the coarsest model first; null for one that is left out. Empty for
    /// one model, and with invented detail, below which models are drawn as they are.
    /// </summary>
    public IReadOnlyList<GridResolution?> Drawn { get; init; } = [];

    /// <summary>Whether the camera has a detector whose numbers are told.</summary>
    public bool HasSignal { get; init; }

    /// <summary>What the detector gives for lit ground; null if none is in the image.</summary>
    public SignalLevels? Signal { get; init; }
}
