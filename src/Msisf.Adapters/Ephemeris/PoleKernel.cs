using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>Reads a body's pole and prime meridian from text PCK kernels.</summary>
/// <remarks>NAIF, PCK Required Reading, "Text PCK Kernel Variable Names".</remarks>
public static class PoleKernel
{
    /// <summary>The variable that each text kernel with a body's orientation has.</summary>
    public const string PoleItem = "POLE_RA";

    private const string Epoch = "CONSTANTS_JED_EPOCH";
    private const string ReferenceFrame = "CONSTANTS_REF_FRAME";

    /// <summary>Reads a body's orientation.</summary>
    /// <param name="pool">Holds the text kernels.</param>
    /// <exception cref="BadInputException">No text kernel has it, or it is not as PCK kernels have it.</exception>
    public static PoleOrientation Read(KernelPool pool, CelestialBody body)
    {
        if (pool.Find(Name(body.NaifNumber, PoleItem)) is null)
        {
            throw Missing(body);
        }

        RefuseOthers(pool, body);
        PoleOrientation orientation = new()
        {
            RightAscension = SeriesOf(pool, body, PoleItem, "RA"),
            Declination = SeriesOf(pool, body, "POLE_DEC", "DEC"),
            Meridian = SeriesOf(pool, body, "PM", "PM"),
            Angles = AnglesOf(pool, body),
        };
        PoleSeries[] all = [orientation.RightAscension, orientation.Declination, orientation.Meridian];
        int terms = all.Max(series => series.Amplitudes.Count);
        return terms <= orientation.Angles.Count ? orientation : throw new BadInputException(Invariant(
            $"{pool.Existing(Name(body.NaifNumber, PoleItem)).Source}: {body.Name} has {terms} periodic terms, but its system has only "
                + $"{orientation.Angles.Count} angles for them. Get the kernel anew."));
    }

    /// <summary>The error for a body without a text kernel.</summary>
    public static BadInputException Missing(CelestialBody body) => new(Invariant(
        $"No text kernel gives the orientation of {body.Name} ({Name(body.NaifNumber, PoleItem)} and others), from which {body.Frame} is "
            + $"made. Give one to --kernels: 'msis fetch kernels' gets NAIF's pck00011.tpc, which has all bodies."));

    private static PoleSeries SeriesOf(KernelPool pool, CelestialBody body, string item, string periodic) => new(
        NumbersOf(pool.Existing(Name(body.NaifNumber, item)), item),
        pool.Find(Name(body.NaifNumber, $"NUT_PREC_{periodic}")) is { } amplitudes ? NumbersOf(amplitudes, periodic) : []);

    private static IReadOnlyList<double> NumbersOf(KernelVariable variable, string name) => variable.Numbers.Count > 0
        ? variable.Numbers
        : throw new BadInputException($"{variable.Source}: {name} of a body's orientation must be numbers.");

    /// <summary>The angles of the body's system: that of Jupiter for 501, and of Mercury for 199.</summary>
    private static IReadOnlyList<IReadOnlyList<double>> AnglesOf(KernelPool pool, CelestialBody body)
    {
        int system = body.NaifNumber / 100;
        if (pool.Find(Name(system, "NUT_PREC_ANGLES")) is not { } variable)
        {
            return [];
        }

        string degree = Name(system, "MAX_PHASE_DEGREE");
        int coefficients = 1 + (pool.Find(degree) is null ? 1 : pool.WholeNumber(degree));
        return coefficients > 1 && variable.Numbers.Count % coefficients == 0
            ? [.. variable.Numbers.Chunk(coefficients)]
            : throw new BadInputException(Invariant(
                $"{variable.Source}: {Name(system, "NUT_PREC_ANGLES")} has {variable.Numbers.Count} numbers; a multiple of {coefficients} "
                    + $"is needed."));
    }

    /// <summary>Kernels may count from another epoch, or in another frame than J2000; those in use do not.</summary>
    private static void RefuseOthers(KernelPool pool, CelestialBody body)
    {
        int system = body.NaifNumber / 100;
        string[] others =
        [
            Name(body.NaifNumber, Epoch), Name(body.NaifNumber, ReferenceFrame), Name(system, Epoch), Name(system, ReferenceFrame),
        ];
        if (others.FirstOrDefault(name => pool.Find(name) is not null) is { } found)
        {
            throw new BadInputException(
                $"{pool.Existing(found).Source}: {found} is not known to the built-in reader. Use --ephemeris cspice.");
        }
    }

    private static string Name(int number, string item) => Invariant($"BODY{number}_{item}");
}
