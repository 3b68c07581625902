using System.Text;
using Msisf.Adapters.Ephemeris;
using Msisf.Core.Attitude;

namespace Msisf.Adapters.Camera;

/// <summary>What an instrument kernel (IK), with the additions that ISIS makes to it, says of a camera.</summary>
/// <remarks>NAIF's tutorial on IKs; the keywords of ISIS's cameras, which count pixels from 1 and look along +z.</remarks>
public sealed class InstrumentKernel
{
    /// <summary>1: a boresight that is farther from +z is not what ISIS's keywords are for.</summary>
    private const double LeastForward = 0.9;

    private readonly KernelPool _pool;
    private readonly int _number;
    private readonly string _name;

    /// <summary>Looks for an instrument.</summary>
    /// <param name="pool">Has the IK, the FK and names.</param>
    /// <param name="nameOrId">Name or number of the instrument.</param>
    /// <exception cref="BadInputException">No kernel knows it.</exception>
    public InstrumentKernel(KernelPool pool, string nameOrId)
    {
        _pool = pool;
        string frameVariable = $"FRAME_{nameOrId.ToUpperInvariant()}";
        int? number = new BodyNames(pool).NumberOf(nameOrId)
            ?? (pool.Find(frameVariable) is not null ? pool.WholeNumber(frameVariable) : null);
        _number = number ?? throw new BadInputException(
            $"No kernel has an instrument '{nameOrId}'. Add its instrument and frame kernel with --kernels, or give its number.");
        Frame = Find("FOV_FRAME") is { Texts: [string frame] } ? frame
            : pool.Find(Invariant($"FRAME_{_number}_NAME")) is { Texts: [string named] } ? named
            : throw new BadInputException(Invariant(
                $"No kernel says which frame instrument {nameOrId} has (INS{_number}_FOV_FRAME, FRAME_{_number}_NAME). Add its instrument ")
                    + "or frame kernel (IK, FK) with --kernels.");
        _name = Frame;
    }

    /// <summary>The instrument's frame.</summary>
    public string Frame { get; }

    /// <summary>How the image lies in the frame, by ITRANSS and ITRANSL.</summary>
    /// <exception cref="BadInputException">A keyword is missing, or they contradict each other.</exception>
    public InstrumentAxes Axes()
    {
        if (Find("BORESIGHT") is { Numbers: [double x, double y, double z] } && z < LeastForward * new Vector3D(x, y, z).Length)
        {
            throw new BadInputException(Invariant(
                $"{Source("BORESIGHT")}: the boresight of {_name} is ({x}, {y}, {z}), not near +z, from which ITRANSS and ITRANSL count. ")
                    + AxesCure);
        }

        (double X, double Y) samples = Gradient("ITRANSS");
        (double X, double Y) lines = Gradient("ITRANSL");
        Vector3D down = new Vector3D(lines.X, lines.Y, 0.0).Normalized();
        Vector3D right = Vector3D.Cross(down, Vector3D.UnitZ);
        if (Lines() == 1)
        {
            // The lines of a line camera follow its flight; the image of one line is never mirrored.
            right = new Vector3D(samples.X, samples.Y, 0.0).Normalized();
            down = Vector3D.Cross(Vector3D.UnitZ, right);
        }
        else if (((samples.X * right.X) + (samples.Y * right.Y)) <= 0.0)
        {
            throw new BadInputException(
                $"{Source("ITRANSS")}: ITRANSS and ITRANSL of {_name} describe an image that is mirrored as seen along +z. {AxesCure}");
        }

        return new InstrumentAxes(right, down);
    }

    /// <summary>The camera as a camera file (docs/cameras.md), by the IK's keywords.</summary>
    /// <param name="given">
    /// How the user says that the image lies in the frame: the pixels are then those of PIXEL_PITCH, and ITRANSS and ITRANSL not used.
    /// </param>
    /// <exception cref="BadInputException">A keyword is missing, or of a form that is not known.</exception>
    /// <remarks>A kernel without a focal length, but with a field of view, describes a pinhole with that.</remarks>
    public CameraFile Camera(InstrumentAxes? given = null) => CameraFileReader.Parse(
        Encoding.UTF8.GetBytes(Find("FOCAL_LENGTH") is null && Find("FOV_SHAPE") is not null
            ? Head() + new InstrumentField(_pool, Invariant($"INS{_number}_")).CameraText(
                given ?? Axes(), Whole("PIXEL_SAMPLES"), Lines())
            : CameraText(given is not null)),
        $"{_name}.yaml", mayNameFiles: false);

    private string Head() => Invariant(
        $"description: {_name} by its instrument kernel\nwidth: {Whole("PIXEL_SAMPLES")}\nheight: {Lines()}\npixel-convention: isis\n");

    private string CameraText(bool hasAxes)
    {
        double focal = Number("FOCAL_LENGTH");
        bool isLine = Lines() == 1;
        (double acrossRight, double acrossDown, double along) = hasAxes ? Pitch() : Transformed(isLine);
        (double sample, double line) = Boresight(isLine, hasAxes);
        double scale = 1.0 - Offset();
        StringBuilder text = new(Head());
        text.Append(CultureInfo.InvariantCulture, $"focal-length: {focal / scale:R}\n");
        text.Append(CultureInfo.InvariantCulture, $"pixel-pitch: [{1.0 / acrossRight:R}, {1.0 / along:R}]\n");
        text.Append(CultureInfo.InvariantCulture, $"principal-point: [{sample:R}, {line:R}]\n");
        if (Math.Abs(acrossDown) > 1e-9 * acrossRight)
        {
            text.Append(CultureInfo.InvariantCulture, $"skew: {acrossDown * focal / scale:R}\n");
        }

        text.Append(Distortion(scale));
        return text.ToString();
    }

    /// <summary>px a mm: samples along right and down, lines along down.</summary>
    private (double AcrossRight, double AcrossDown, double Along) Transformed(bool isLine)
    {
        (double X, double Y) samples = Gradient("ITRANSS");
        (double X, double Y) lines = Gradient("ITRANSL");
        InstrumentAxes axes = Axes();
        return (
            (samples.X * axes.Right.X) + (samples.Y * axes.Right.Y),
            isLine ? 0.0 : (samples.X * axes.Down.X) + (samples.Y * axes.Down.Y),
            isLine ? double.Hypot(lines.X, lines.Y) : (lines.X * axes.Down.X) + (lines.Y * axes.Down.Y));
    }

    private (double AcrossRight, double AcrossDown, double Along) Pitch() =>
        Number("PIXEL_PITCH") is > 0.0 and double millimetres
            ? (1.0 / millimetres, 0.0, 1.0 / millimetres)
            : throw new BadInputException($"{Source("PIXEL_PITCH")}: PIXEL_PITCH of {_name} is not above 0. {CameraCure}");

    private const string AxesCure = "Say how the image lies with --instrument-axes.";

    private const string CameraCure = "Give the camera with --camera instead.";

    private string Distortion(double scale) => Find("OD_K") switch
    {
        null => string.Empty,
        { Numbers: [double k] } => Invariant($"distortion:\n  model: radial\n  form: division\n  k: [{k:R}]\n"),
        { Numbers: [_, double k1, double k2] } =>
            Invariant($"distortion:\n  model: radial\n  form: factor\n  k: [{-k1 / scale:R}, {-k2 / scale:R}]\n"),
        { } other => throw new BadInputException(
            $"{other.Source}: OD_K of {_name} has {other.Numbers.Count} numbers; 1 (LROC's) and 3 (ISIS's) are known. {CameraCure}"),
    };

    /// <summary>ISIS's radial distortion takes (k0 + k1 r2 + k2 r4) off; k0 changes the focal length.</summary>
    private double Offset() => Find("OD_K") is { Numbers: [double k0, _, _] } ? k0 : 0.0;

    /// <summary>The pixel of the boresight, counted from 1.</summary>
    private (double Sample, double Line) Boresight(bool isLine, bool hasAxes)
    {
        double line = 1.0;
        if (Find("BORESIGHT_SAMPLE") is { Numbers: [double sample] })
        {
            return (sample, isLine ? line : Number("BORESIGHT_LINE"));
        }

        double[] center = Numbers("CCD_CENTER", 2);
        (double ofSample, double ofLine) = hasAxes ? (0.0, 0.0) : (Numbers("ITRANSS", 3)[0], Numbers("ITRANSL", 3)[0]);
        return (center[0] + ofSample, isLine ? line : center[1] + ofLine);
    }

    private int Lines() => Whole("PIXEL_LINES");

    private (double X, double Y) Gradient(string item)
    {
        if (Find(item) is null)
        {
            throw new BadInputException(Invariant(
                $"No kernel has INS{_number}_{item} of {_name}, which says how its image lies; ISIS's addendum to the IK has it. "
                    + $"{AxesCure}"));
        }

        double[] numbers = Numbers(item, 3);
        return numbers[1] != 0.0 || numbers[2] != 0.0
            ? (numbers[1], numbers[2])
            : throw new BadInputException($"{Source(item)}: {item} of {_name} has no direction. {AxesCure}");
    }

    private double Number(string item) => Numbers(item, 1)[0];

    private int Whole(string item)
    {
        Numbers(item, 1);
        return _pool.WholeNumber(Invariant($"INS{_number}_{item}"));
    }

    private double[] Numbers(string item, int count)
    {
        if (Find(item) is null)
        {
            throw new BadInputException(Invariant(
                $"No kernel has INS{_number}_{item} of {_name}. Add its instrument kernel (IK) with --kernels. ") + CameraCure);
        }

        return [.. _pool.Numbers(Invariant($"INS{_number}_{item}"), count)];
    }

    private KernelVariable? Find(string item) => _pool.Find(Invariant($"INS{_number}_{item}"));

    private string Source(string item) => _pool.Existing(Invariant($"INS{_number}_{item}")).Source;
}
