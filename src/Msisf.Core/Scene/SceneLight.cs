using Msisf.Core.Numerics;

namespace Msisf.Core.Scene;

/// <summary>The one light of a scene.</summary>
/// <param name="PositionMoonMe">m, MOON_ME.</param>
/// <param name="IsSun">The Sun; otherwise a lamp at the camera (<c>--ignore-sun</c>), which has no disc.</param>
public readonly record struct SceneLight(Vector3D PositionMoonMe, bool IsSun);
