using Msisf.Core.Scene;

namespace Msisf.Core.Render.Options;

/// <summary>A light beside the Sun: a frame is drawn in it once more, with its own shadows, and both are added.</summary>
/// <param name="Light">Where it is, and how large.</param>
/// <param name="OverSunlight">Its light on the ground over sunlight at 1 au.</param>
public sealed record SecondLight(SceneLight Light, double OverSunlight);
