using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Core.Scene;

/// <summary>What must be known of a camera's path to draw the sky that fits its ground.</summary>
/// <param name="OfGround">What the finite speed of light does to its ground.</param>
/// <param name="VelocityJ2000">Velocity of the camera relative to the body's centre, m/s, J2000, at a time.</param>
public sealed record SkyObserver(Aberration OfGround, Func<Instant, Vector3D> VelocityJ2000);
