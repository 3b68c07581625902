using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// One of six maps that together hold the Moon, about the ends of the axes of MOON_ME, on whose lattices all generated windows lie: of
/// level k the samples of the lattice are 2^k m apart, and every second one is a sample of level k + 1.
/// </summary>
/// <param name="Turn">Axis of the middle of the map (<see cref="PolarStereographic.Turn"/>).</param>
/// <param name="IsSouth">Whether it is the axis's negative end.</param>
internal readonly record struct LatticeFace(int Turn, bool IsSouth)
{
    /// <summary>The map in whose middle a direction is most nearly; it lies within 0.83 radii of the Moon of it.</summary>
    public static LatticeFace Of(Vector3D direction)
    {
        (double x, double y, double z) = (Math.Abs(direction.X), Math.Abs(direction.Y), Math.Abs(direction.Z));
        return z >= x && z >= y
            ? new LatticeFace(0, direction.Z < 0.0)
            : x >= y ? new LatticeFace(1, direction.X < 0.0) : new LatticeFace(2, direction.Y < 0.0);
    }

    /// <summary>The map at a level, counted from a line and a sample of the lattice.</summary>
    public PolarStereographic Map(int level, int firstLine = 0, int firstSample = 0) =>
        new(IsSouth, Math.ScaleB(1.0, level), -firstLine, -firstSample) { Turn = Turn };
}
