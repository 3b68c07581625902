namespace Msisf.Adapters.Ephemeris;

/// <summary>The inertial frames that SPICE knows without a kernel, by NAIF's numbers 1 to 21.</summary>
/// <remarks>NAIF, Frames Required Reading, "Built-in Inertial Reference Frames"; the angles are those of SPICELIB's CHGIRF.</remarks>
internal static class InertialFrames
{
    /// <summary>NAIF's number of the frame along whose axes all others are given.</summary>
    public const int J2000 = 1;

    private const double ArcsecondsPerDegree = 3600.0;

    /// <summary>
    /// The frames in the order of their numbers. Each is turned from an earlier one by frame rotations about axes 1, 2 and 3, the last of
    /// them first; angles in arcseconds.
    /// </summary>
    private static readonly (string Name, string Base, (double Arcseconds, int Axis)[] Turns)[] Known =
    [
        ("J2000", "J2000", []),
        ("B1950", "J2000", [(1152.84248596724, 3), (-1002.26108439117, 2), (1153.04066200330, 3)]),
        ("FK4", "B1950", [(0.525, 3)]),
        ("DE-118", "B1950", [(0.53155, 3)]),
        ("DE-96", "B1950", [(0.4107, 3)]),
        ("DE-102", "B1950", [(0.1359, 3)]),
        ("DE-108", "B1950", [(0.4775, 3)]),
        ("DE-111", "B1950", [(0.5880, 3)]),
        ("DE-114", "B1950", [(0.5529, 3)]),
        ("DE-122", "B1950", [(0.5316, 3)]),
        ("DE-125", "B1950", [(0.5754, 3)]),
        ("DE-130", "B1950", [(0.5247, 3)]),
        ("GALACTIC", "FK4", [(1177200.0, 3), (225360.0, 1), (1016100.0, 3)]),
        ("DE-200", "J2000", []),
        ("DE-202", "J2000", []),
        ("MARSIAU", "J2000", [(324000.0, 3), (133610.4, 2), (-152348.4, 3)]),
        ("ECLIPJ2000", "J2000", [(84381.448, 1)]),
        ("ECLIPB1950", "B1950", [(84404.836, 1)]),
        ("DE-140", "J2000", [(1152.71013777252, 3), (-1002.25042010533, 2), (1153.75719544491, 3)]),
        ("DE-142", "J2000", [(1152.72061453864, 3), (-1002.25052830351, 2), (1153.74663857521, 3)]),
        ("DE-143", "J2000", [(1153.03919093833, 3), (-1002.24822382286, 2), (1153.42900222357, 3)]),
    ];

    private static readonly RotationMatrix[] FromJ2000 = [.. Known.Select((_, index) => MatrixOf(index))];

    /// <summary>NAIF's numbers of the frames.</summary>
    public static IEnumerable<int> Numbers => Enumerable.Range(J2000, Known.Length);

    /// <summary>The number of a frame; null if it is none of these.</summary>
    public static int? NumberOf(string name) =>
        Array.FindIndex(Known, known => known.Name.Equals(name, StringComparison.OrdinalIgnoreCase)) is >= 0 and int index
            ? index + 1
            : null;

    /// <summary>The name of a number; null if it is none of these frames.</summary>
    public static string? NameOf(int number) => number >= 1 && number <= Known.Length ? Known[number - 1].Name : null;

    /// <summary>The constant rotation that turns J2000 components into those of a frame.</summary>
    /// <param name="number">One of <see cref="Numbers"/>.</param>
    public static RotationMatrix FrameFromJ2000(int number) => FromJ2000[number - 1];

    private static RotationMatrix MatrixOf(int index)
    {
        (string name, string basis, (double, int)[] turns) = Known[index];
        RotationMatrix matrix = name == basis ? RotationMatrix.Identity : MatrixOf(NumberOf(basis)!.Value - 1);
        foreach ((double arcseconds, int axis) in turns.Reverse())
        {
            matrix = RotationMatrix.FrameAbout(axis, double.DegreesToRadians(arcseconds / ArcsecondsPerDegree)) * matrix;
        }

        return matrix;
    }
}
