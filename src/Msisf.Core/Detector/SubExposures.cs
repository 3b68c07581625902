namespace Msisf.Core.Detector;

/// <summary>
/// The instants for which a frame, or a row of a rolling shutter, is drawn to sum up its exposure. They lie in the middle of equal parts of
/// the time in which the shutter is open. Immutable.
/// </summary>
public sealed class SubExposures
{
    private readonly double _exposureTime;

    internal SubExposures(int count, double exposureTime) => (Count, _exposureTime) = (count, exposureTime);

    /// <summary>How many; odd, so that one of them is the middle of the exposure.</summary>
    public int Count { get; }

    /// <summary>Index of the middle.</summary>
    public int Middle => Count / 2;

    /// <summary>Part of the exposure for which each of them stands.</summary>
    public double Weight => 1.0 / Count;

    /// <summary>Seconds after the middle.</summary>
    /// <param name="index">From 0.</param>
    public double TimeOf(int index) => (index - Middle) * _exposureTime / Count;
}
