using Msisf.Core.Ephemeris;

namespace Msisf.Adapters.Ephemeris;

/// <summary>
/// The frames that kernels define: inertial ones, those of binary PCKs, of CKs, and constant offsets from any of them. Thread-safe.
/// </summary>
/// <remarks>NAIF, Frames Required Reading.</remarks>
internal sealed class FrameSystem : ISpaceFrames
{
    private const int PckClass = 2;
    private const int CkClass = 3;
    private const int TkClass = 4;

    /// <summary>Maximum number of frames from one to J2000; more mean that they are defined by each other.</summary>
    private const int MaximumLinks = 20;

    /// <summary>rad: obliquity of the ecliptic at J2000 (IAU 1976), 84381.448 arcseconds.</summary>
    private const double Obliquity = 84381.448 / 3600.0 * Math.PI / 180.0;

    private static readonly Dictionary<string, int> BuiltIn = new(StringComparer.Ordinal) { ["J2000"] = 1, ["ECLIPJ2000"] = 17 };

    private readonly KernelPool _pool;
    private readonly Lazy<SegmentTable> _orientations;
    private readonly SpacecraftAttitudes _attitudes;

    /// <param name="pool">Has the frame kernels.</param>
    /// <param name="orientations">Segments of the binary PCKs.</param>
    /// <param name="attitudes">Segments of the CKs.</param>
    public FrameSystem(KernelPool pool, Func<SegmentTable> orientations, SpacecraftAttitudes attitudes) =>
        (_pool, _orientations, _attitudes) = (pool, new Lazy<SegmentTable>(orientations), attitudes);

    public RotationMatrix FrameFromJ2000(string frame, double tdbSeconds) => FromJ2000(frame, tdbSeconds, 0);

    /// <summary>The rotation that turns J2000 components into those of a frame.</summary>
    /// <param name="frame">NAIF's number of the frame.</param>
    /// <param name="tdbSeconds">TDB seconds past J2000.</param>
    /// <exception cref="MsisfException">The frame is not known, or not at that time.</exception>
    public RotationMatrix FrameFromJ2000(int frame, double tdbSeconds) => FromJ2000(NameOf(frame), tdbSeconds, 0);

    /// <summary>The class IDs of the CK frames on the way from a frame to one that is not of a CK.</summary>
    /// <exception cref="BadInputException">The frame is not known.</exception>
    public IReadOnlyList<int> AttitudesOf(string frame)
    {
        List<int> instruments = [];
        string current = frame;
        for (int links = 0; links < MaximumLinks && !BuiltIn.ContainsKey(current); links++)
        {
            (int id, int kind) = ClassOf(current);
            if (kind is not (CkClass or TkClass))
            {
                break;
            }

            if (kind == CkClass)
            {
                instruments.Add(ClassIdOf(current, id));
            }

            current = kind == TkClass
                ? _pool.Text(FrameKernel.Variable(_pool, "TKFRAME", id, current, "RELATIVE"))
                : _attitudes.ReferenceOf(instruments[^1]) is { } reference ? NameOf(reference) : "J2000";
        }

        return instruments;
    }

    /// <summary>The name of a frame's number with the number, or that alone.</summary>
    public string Describe(int frame) => NameIfKnown(frame) is { } name
        ? Invariant($"{name} ({frame})")
        : frame.ToString(CultureInfo.InvariantCulture);

    private RotationMatrix FromJ2000(string frame, double tdbSeconds, int links)
    {
        if (links > MaximumLinks)
        {
            throw new BadInputException($"Frame {frame} is defined by itself, over other frames. Use other frame kernels.");
        }

        if (BuiltIn.TryGetValue(frame, out int builtIn))
        {
            return builtIn == 1 ? RotationMatrix.Identity : RotationMatrix.FrameAboutX(Obliquity);
        }

        (int id, int kind) = ClassOf(frame);
        switch (kind)
        {
            case PckClass:
                KernelOrientation orientation = new(
                    _orientations.Value, new BodyFixedFrame(ClassIdOf(frame, id), RotationMatrix.Identity));
                return orientation.FrameFromJ2000(tdbSeconds) ?? throw new BadInputException(
                    $"No binary PCK has the orientation of frame {frame} at that time. Add it, or choose another time.");
            case CkClass:
                (RotationMatrix turn, int reference) = _attitudes.InstrumentFromReference(ClassIdOf(frame, id), frame, tdbSeconds);
                return turn * FromJ2000(NameOf(reference), tdbSeconds, links + 1);
            case TkClass:
                string relative = _pool.Text(FrameKernel.Variable(_pool, "TKFRAME", id, frame, "RELATIVE"));
                return FrameKernel.ReadRelativeFromFrame(_pool, id, frame).Transposed * FromJ2000(relative, tdbSeconds, links + 1);
            default:
                throw new BadInputException(
                    $"Frame {frame} is of class {kind}; the built-in reader knows the classes 2 (binary PCK), 3 (CK) and 4 (constant). "
                        + "Use --ephemeris cspice.");
        }
    }

    private (int Id, int Class) ClassOf(string frame)
    {
        if (_pool.Find($"FRAME_{frame}") is null)
        {
            throw new BadInputException(
                $"No frame kernel defines the frame {frame}. Add its frame kernel (FK) with --kernels, or use --ephemeris cspice if it is "
                    + "one that SPICE itself knows.");
        }

        int id = _pool.WholeNumber($"FRAME_{frame}");
        int kind = _pool.WholeNumber(FrameKernel.Variable(_pool, "FRAME", id, frame, "CLASS"));
        return (id, kind);
    }

    private int ClassIdOf(string frame, int id) => _pool.WholeNumber(FrameKernel.Variable(_pool, "FRAME", id, frame, "CLASS_ID"));

    private string NameOf(int frame) => NameIfKnown(frame) ?? throw new BadInputException(Invariant(
        $"A kernel gives data in frame {frame}, which no frame kernel names. Add its FK with --kernels, or use --ephemeris cspice."));

    private string? NameIfKnown(int frame)
    {
        string variable = Invariant($"FRAME_{frame}_NAME");
        return BuiltIn.FirstOrDefault(known => known.Value == frame).Key
            ?? (_pool.Find(variable) is not null ? _pool.Text(variable) : null);
    }
}
