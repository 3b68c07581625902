namespace Msisf.Core.Certainty;

/// <summary>By how much what an image shows may differ from what is drawn.</summary>
/// <param name="Height">m: each corner of each facet for itself, up or down.</param>
/// <param name="Position">m: the camera, in any direction.</param>
/// <param name="Turn">rad: the camera, about any axis.</param>
/// <param name="Sun">rad: the direction to the Sun's centre, to any side.</param>
public sealed record Uncertainty(double Height, double Position, double Turn, double Sun);
