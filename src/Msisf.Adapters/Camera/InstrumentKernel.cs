using System.Text;
using Msisf.Adapters.Ephemeris;
using Msisf.Core.Attitude;

namespace Msisf.Adapters.Camera;

/// <summary>What an instrument kernel (IK), with the additions that ISIS makes to it, says of a camera.</summary>
/// <remarks>NAIF's tutorial on IKs; the keywords of ISIS's cameras; the lenses of <see cref="InstrumentOptics"/>.</remarks>
public sealed class InstrumentKernel
{
    /// <summary>1: a boresight that is farther from +z is not what ISIS's keywords are for.</summary>
    private const double LeastForward = 0.9;

    /// <summary>1: a boresight that is nearer to the axis of the image is along it; kernels have six digits.</summary>
    private const double AlongAxis = 1e-6;

    private const string AxesCure = "Say how the image lies with --instrument-axes.";

    private readonly KernelPool _pool;
    private readonly InstrumentKeywords _keywords;
    private readonly InstrumentOptics? _optics;

    /// <summary>Looks for an instrument.</summary>
    /// <param name="pool">Has the IK, the FK and names.</param>
    /// <param name="nameOrId">Name or number of the instrument.</param>
    /// <exception cref="BadInputException">No kernel knows it.</exception>
    public InstrumentKernel(KernelPool pool, string nameOrId)
    {
        _pool = pool;
        string frameVariable = $"FRAME_{nameOrId.ToUpperInvariant()}";
        int number = new BodyNames(pool).NumberOf(nameOrId)
            ?? (pool.Find(frameVariable) is not null ? pool.WholeNumber(frameVariable) : (int?)null)
            ?? throw new BadInputException(
                $"No kernel has an instrument '{nameOrId}'. Add its instrument and frame kernel with --kernels, or give its number.");
        Frame = pool.Find(Invariant($"INS{number}_FOV_FRAME")) is { Texts: [string frame] } ? frame
            : pool.Find(Invariant($"FRAME_{number}_NAME")) is { Texts: [string named] } ? named
            : throw new BadInputException(Invariant(
                $"No kernel says which frame instrument {nameOrId} has (INS{number}_FOV_FRAME, FRAME_{number}_NAME). Add its instrument ")
                    + "or frame kernel (IK, FK) with --kernels.");
        _keywords = new InstrumentKeywords(pool, number, Frame);
        _optics = InstrumentOptics.Of(number);
    }

    /// <summary>The instrument's frame.</summary>
    public string Frame { get; }

    /// <summary>
    /// The camera that a cube's own keywords state: those that ISIS took from the kernels. What ISIS knows without a kernel, or counts in
    /// its own way, is added: the detector's size, and of Kaguya's cameras CENTER by BORESIGHT_SAMPLE, which counts from 0.
    /// </summary>
    /// <param name="keywords">The numbers of the cube's NaifKeywords.</param>
    /// <param name="number">NAIF's number of the instrument.</param>
    /// <param name="samples">Width of the detector, px.</param>
    /// <param name="lines">Height of the detector, px.</param>
    /// <param name="source">The cube, for messages.</param>
    /// <returns>Null if the keywords are not all there, or no row of the table has the instrument.</returns>
    public static InstrumentKernel? OfCube(
        IEnumerable<KeyValuePair<string, double[]>> keywords, int number, int samples, int lines, string source)
    {
        KernelPool pool = new();
        string prefix = Invariant($"INS{number}_");
        foreach ((string name, double[] numbers) in keywords.Where(pair => pair.Key.StartsWith(prefix, StringComparison.Ordinal)))
        {
            pool.Assign(name, new KernelVariable(numbers, [], source));
        }

        string[] always = ["FOCAL_LENGTH", "ITRANSS", "ITRANSL", "BORESIGHT_SAMPLE"];
        if (InstrumentOptics.Of(number) is not { } optics || always.Concat(optics.Keywords).Any(item => pool.Find(prefix + item) is null))
        {
            return null;
        }

        if (optics.Center is { } center)
        {
            Assign(center, pool.Numbers($"{prefix}BORESIGHT_SAMPLE", 1)[0] + 1.0, 1.0);
        }

        if (pool.Find($"{prefix}PIXEL_PITCH") is { Numbers: [double pitch] })
        {
            Assign(optics.Pitch, pitch);
        }

        Assign("PIXEL_SAMPLES", samples);
        Assign("PIXEL_LINES", lines);
        pool.Assign($"{prefix}FOV_FRAME", new KernelVariable([], [optics.Family], source));
        return new InstrumentKernel(pool, number.ToString(CultureInfo.InvariantCulture));

        void Assign(string item, params double[] numbers) => pool.Assign(prefix + item, new KernelVariable(numbers, [], source));
    }

    private bool IsLine => _optics is { IsLine: true } || (_keywords.Find("PIXEL_LINES") is not null && Lines == 1);

    private int Samples => _optics?.Window?.Samples ?? (_optics?.Size is { } size && _keywords.Find("PIXEL_SAMPLES") is null
        ? size.Samples
        : _keywords.Whole("PIXEL_SAMPLES"));

    private int Lines => _optics?.Window?.Lines ?? (_optics is { IsLine: true } ? 1 : _keywords.Whole("PIXEL_LINES"));

    /// <summary>How the image lies in the frame, by ITRANSS and ITRANSL, or by the formula of its kernel.</summary>
    /// <exception cref="BadInputException">A keyword is missing, or they contradict each other.</exception>
    public InstrumentAxes Axes()
    {
        if (_keywords.Find("BORESIGHT") is { Numbers: [double x, double y, double z] } && z < LeastForward * new Vector3D(x, y, z).Length)
        {
            throw new BadInputException(Invariant(
                $"{Source("BORESIGHT")}: the boresight of {Frame} is ({x}, {y}, {z}), not near +z, from which ITRANSS and ITRANSL count. ")
                    + AxesCure);
        }

        FocalPlane? plane = Transforms();
        return plane is { IsMirrored: true }
            ? throw new BadInputException(
                $"{Source("ITRANSS")}: ITRANSS and ITRANSL of {Frame} describe an image that is mirrored as seen along +z. {AxesCure}")
            : plane?.Axes ?? _optics?.Axes ?? throw new BadInputException(
                $"No kernel has {_keywords.Prefix}ITRANSS of {Frame}, which says how its image lies; ISIS's addendum to the IK has it. "
                    + AxesCure);
    }

    /// <summary>The camera as a camera file (docs/cameras.md), by the IK's keywords.</summary>
    /// <param name="given">
    /// How the user says that the image lies in the frame, in place of the directions of ITRANSS and ITRANSL.
    /// </param>
    /// <exception cref="BadInputException">
    /// A keyword is missing, of a form that is not known, or turns rays in a way that is not known.
    /// </exception>
    /// <remarks>A kernel without a focal length, but with a field of view, describes a pinhole with that.</remarks>
    public CameraFile Camera(InstrumentAxes? given = null) =>
        CameraFileReader.Parse(Encoding.UTF8.GetBytes(CameraText(given)), $"{Frame}.yaml", mayNameFiles: false);

    /// <summary>The text of that file.</summary>
    /// <inheritdoc cref="Camera" path="/param"/>
    /// <inheritdoc cref="Camera" path="/exception"/>
    public string CameraText(InstrumentAxes? given = null)
    {
        bool isOfField = _keywords.Find("FOCAL_LENGTH") is null && _keywords.Find("FOV_SHAPE") is not null;
        _keywords.RefuseUnread(isOfField ? [] : _optics?.Read ?? []);
        return isOfField
            ? Head(1) + new InstrumentField(_pool, _keywords.Prefix).CameraText(given ?? Axes(), Samples, Lines)
            : TextOfLens(given);
    }

    private FocalPlane? Transforms() => FocalPlane.OfTransforms(_keywords, IsLine, _optics?.Pitch ?? "PIXEL_PITCH");

    private string Head(int summed) => Invariant(
        $"description: {Frame} by its instrument kernel{(summed == 1 ? string.Empty : Invariant($", {summed} x {summed} px summed"))}\n")
            + Invariant($"width: {Samples / summed}\nheight: {Math.Max(1, Lines / summed)}\npixel-convention: isis\n");

    private string TextOfLens(InstrumentAxes? given)
    {
        InstrumentAxes axes = given ?? Axes();
        if (_optics?.Keywords.Contains("BORESIGHT") != true)
        {
            RequireBoresight(Vector3D.Cross(axes.Right, axes.Down));
        }

        if (_optics?.CountsFrom is { } needed)
        {
            _keywords.Value(needed);
        }

        FocalPlane plane = Transforms() ?? FocalPlane.OfPitch(_keywords, _optics?.Axes ?? axes, _optics?.Pitch ?? "PIXEL_PITCH");
        KernelLens lens = _optics?.Lens(_keywords, plane) ?? new KernelLens(_keywords.Value("FOCAL_LENGTH"), string.Empty);
        (double right, double down) = plane.ToImage(lens.Axis.X, lens.Axis.Y);
        (double sample, double line) = Boresight(plane);
        sample += (plane.SamplesRight * right) + (plane.SamplesDown * down);
        line += plane.LinesDown * down;
        int summed = (Math.Max(Samples, Lines) + CameraFileReader.MaxSide - 1) / CameraFileReader.MaxSide;
        StringBuilder text = new(Head(summed));
        text.Append(CultureInfo.InvariantCulture, $"focal-length: {lens.FocalLength:R}\n");
        text.Append(CultureInfo.InvariantCulture, $"pixel-pitch: [{summed / plane.SamplesRight:R}, {summed / plane.LinesDown:R}]\n");
        text.Append(CultureInfo.InvariantCulture, $"principal-point: [{Sum(sample):R}, {Sum(line):R}]\n");
        if (!IsLine && Math.Abs(plane.SamplesDown) > 1e-9 * plane.SamplesRight)
        {
            text.Append(CultureInfo.InvariantCulture, $"skew: {plane.SamplesDown * lens.FocalLength / summed:R}\n");
        }

        return text.Append(lens.Distortion).ToString();

        double Sum(double pixel) => ((pixel - 0.5) / summed) + 0.5;
    }

    /// <summary>The pixel of the optical axis, counted from 1.</summary>
    private (double Sample, double Line) Boresight(FocalPlane plane)
    {
        double fromOne = 1.0 - (_optics?.FirstPixel ?? 1.0);
        string? center = _optics?.Center ?? (_keywords.Find("BORESIGHT_SAMPLE") is null ? "CCD_CENTER" : null);
        double sample = center is null ? _keywords.Value("BORESIGHT_SAMPLE") : _keywords.Numbers(center, 2)[0];
        string item = center ?? "BORESIGHT_LINE";
        double line = IsLine && _keywords.Find(item) is null ? 1.0
            : center is null ? _keywords.Value(item) : _keywords.Numbers(center, 2)[1];
        if (IsLine)
        {
            // Kernels call the only line of a line camera 0 or 1.
            line = line is 0.0 or 1.0
                ? 1.0 - fromOne
                : throw _keywords.Wrong(item, Invariant($"puts the axis into line {line} of an image of one line"));
        }

        (double left, double above) = _optics?.Window is { } window
            ? (_keywords.Value(window.SampleOffset), _keywords.Value(window.LineOffset))
            : (0.0, 0.0);
        return (sample - left + fromOne + plane.Constant.Sample, line - above + fromOne + plane.Constant.Line);
    }

    private void RequireBoresight(Vector3D axis)
    {
        if (_keywords.Find("BORESIGHT") is { Numbers: [double x, double y, double z] }
            && Vector3D.Cross(new Vector3D(x, y, z).Normalized(), axis).Length > AlongAxis)
        {
            throw _keywords.Wrong("BORESIGHT", Invariant(
                $"is ({x}, {y}, {z}), off the axis of its image, and no formula is known in which instrument {_keywords.Number} has it"));
        }
    }

    private string Source(string item) => _pool.Existing(_keywords.Prefix + item).Source;
}
