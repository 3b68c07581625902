using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.Adapters.Ephemeris;

/// <summary>
/// The frames that kernels define: inertial ones, those of binary PCKs, of CKs, and constant offsets from any of them. Thread-safe.
/// </summary>
/// <remarks>NAIF, Frames Required Reading.</remarks>
internal sealed class FrameSystem : ISpaceFrames
{
    /// <summary>Maximum number of frames from one to J2000; more mean that they are defined by each other.</summary>
    private const int MaximumLinks = 20;

    private readonly KernelPool _pool;
    private readonly Lazy<SegmentTable> _orientations;
    private readonly SpacecraftAttitudes _attitudes;

    /// <param name="pool">Has the frame kernels.</param>
    /// <param name="orientations">Segments of the binary PCKs.</param>
    /// <param name="attitudes">Segments of the CKs.</param>
    public FrameSystem(KernelPool pool, Func<SegmentTable> orientations, SpacecraftAttitudes attitudes) =>
        (_pool, _orientations, _attitudes) = (pool, new Lazy<SegmentTable>(orientations), attitudes);

    public RotationMatrix FrameFromJ2000(string frame, TdbTime tdb) => Of(frame, tdb, 0).FromJ2000;

    /// <summary>The rotation that turns J2000 components into those of a frame.</summary>
    /// <param name="frame">NAIF's number of the frame.</param>
    /// <exception cref="MsisfException">The frame is not known, or not at that time.</exception>
    public RotationMatrix FrameFromJ2000(int frame, TdbTime tdb) => FrameFromJ2000(NameOf(frame), tdb);

    /// <summary>How fast a frame turns, as kernels say it.</summary>
    /// <param name="frame">The frame's name.</param>
    /// <param name="tdb">TDB seconds past J2000.</param>
    /// <returns>rad/s relative to J2000, along its axes; null if a CK on the way to J2000 does not say it.</returns>
    /// <exception cref="MsisfException">The frame is not known, or not at that time.</exception>
    public Vector3D? RateJ2000(string frame, TdbTime tdb) => Of(frame, tdb, 0).Rate;

    /// <summary>The class IDs of the CK frames on the way from a frame to one that is not of a CK, or that no kernel defines.</summary>
    /// <exception cref="BadInputException">The frame itself is not known.</exception>
    public IReadOnlyList<int> AttitudesOf(string frame)
    {
        List<int> instruments = [];
        FrameDefinition? current = InertialFrames.NumberOf(frame) is null ? DefinitionOf(frame) : null;
        for (int links = 0; links < MaximumLinks && current is not null; links++)
        {
            string? next = null;
            if (current.Class == FrameDefinition.CkClass)
            {
                instruments.Add(current.ClassId);
                next = _attitudes.ReferenceOf(current.ClassId) is { } reference ? NameIfKnown(reference) : null;
            }
            else if (current.Class == FrameDefinition.TkClass)
            {
                next = current.Relative;
            }

            current = next is null ? null : FrameDefinition.Find(_pool, next);
        }

        return instruments;
    }

    /// <summary>The name of a frame's number with the number, or that alone.</summary>
    public string Describe(int frame) => NameIfKnown(frame) is { } name
        ? Invariant($"{name} ({frame})")
        : frame.ToString(CultureInfo.InvariantCulture);

    private (RotationMatrix FromJ2000, Vector3D? Rate) Of(string frame, TdbTime tdb, int links)
    {
        if (links > MaximumLinks)
        {
            throw new BadInputException($"Frame {frame} is defined by itself, over other frames. Use other frame kernels.");
        }

        if (InertialFrames.NumberOf(frame) is { } inertial)
        {
            return (InertialFrames.FrameFromJ2000(inertial), default(Vector3D));
        }

        FrameDefinition definition = DefinitionOf(frame);
        switch (definition.Class)
        {
            case FrameDefinition.PckClass:
                KernelOrientation orientation = new(_orientations.Value, new BodyFixedFrame(definition.ClassId, RotationMatrix.Identity));
                return orientation.FrameFromJ2000(tdb) is { } fromJ2000
                    ? (fromJ2000, orientation.RateJ2000(tdb))
                    : throw new BadInputException(
                        $"No binary PCK has the orientation of frame {frame} at that time. Add it, or choose another time.");
            case FrameDefinition.CkClass:
                (CkAttitude attitude, int number) = _attitudes.At(definition.ClassId, frame, tdb);
                (RotationMatrix FromJ2000, Vector3D? Rate) reference = Of(NameOf(number), tdb, links + 1);
                return (
                    attitude.InstrumentFromReference * reference.FromJ2000,
                    attitude.Rate is { } rate ? (reference.FromJ2000.Transposed * rate) + reference.Rate : null);
            case FrameDefinition.TkClass:
                (RotationMatrix FromJ2000, Vector3D? Rate) relative = Of(definition.Relative, tdb, links + 1);
                return relative with { FromJ2000 = definition.RelativeFromFrame().Transposed * relative.FromJ2000 };
            default:
                throw new BadInputException(
                    $"Frame {frame} is of class {definition.Class}; the built-in reader knows the classes 2 (binary PCK), 3 (CK) and 4 "
                        + "(constant). Use --ephemeris cspice.");
        }
    }

    private FrameDefinition DefinitionOf(string frame) => FrameDefinition.Find(_pool, frame) ?? throw new BadInputException(
        $"No frame kernel defines the frame {frame}. Add its frame kernel (FK) with --kernels, or use --ephemeris cspice if it is "
            + "one that SPICE itself knows.");

    private string NameOf(int frame) => NameIfKnown(frame) ?? throw new BadInputException(Invariant(
        $"A kernel gives data in frame {frame}, which no frame kernel names. Add its FK with --kernels, or use --ephemeris cspice if it is "
            + $"one that SPICE itself knows."));

    private string? NameIfKnown(int frame) => InertialFrames.NameOf(frame) ?? FrameDefinition.NameOf(_pool, frame);
}
