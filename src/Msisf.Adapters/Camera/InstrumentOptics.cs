using Msisf.Core.Attitude;

namespace Msisf.Adapters.Camera;

/// <summary>What a lens of a kernel adds to a camera file.</summary>
/// <param name="FocalLength">mm.</param>
/// <param name="Distortion">The section "distortion" of a camera file; empty for a pinhole.</param>
/// <param name="Axis">mm, in the focal plane: the point from which the lens counts.</param>
internal readonly record struct KernelLens(double FocalLength, string Distortion, (double X, double Y) Axis = default);

/// <summary>A part of a detector.</summary>
/// <param name="SampleOffset">The keyword of the samples on its left.</param>
/// <param name="LineOffset">The keyword of the lines above it.</param>
/// <param name="Samples">px.</param>
/// <param name="Lines">px.</param>
internal readonly record struct DetectorWindow(string SampleOffset, string LineOffset, int Samples, int Lines);

/// <summary>
/// A row of the table of instruments (docs/missions.md): how the kernels of a family count pixels, and by which formula they undo the lens.
/// The formulas are those that the comments of the kernels print, for M3 and Apollo, whose kernels print none, those of ISIS.
/// </summary>
/// <param name="Family">For the docs and messages.</param>
/// <param name="Instruments">NAIF's numbers.</param>
/// <param name="Source">Whose formula it is.</param>
/// <param name="Keywords">The keywords of the lens.</param>
/// <param name="Lens">Reads them.</param>
internal sealed record InstrumentOptics(
    string Family, int[] Instruments, string Source, string[] Keywords, Func<InstrumentKeywords, FocalPlane, KernelLens> Lens)
{
    /// <summary>What the kernel calls the first pixel.</summary>
    public double FirstPixel { get; init; } = 1.0;

    /// <summary>The keyword of the axis' sample and line, in place of BORESIGHT_SAMPLE and BORESIGHT_LINE.</summary>
    public string? Center { get; init; }

    /// <summary>The keyword of the pitch.</summary>
    public string Pitch { get; init; } = "PIXEL_PITCH";

    /// <summary>Whether an image is one line, whatever PIXEL_LINES says.</summary>
    public bool IsLine { get; init; }

    /// <summary>px: the detector, where no kernel has PIXEL_SAMPLES.</summary>
    public (int Samples, int Lines)? Size { get; init; }

    /// <summary>How the image lies in the frame by the kernel's formula, where there are no ITRANSS and ITRANSL.</summary>
    public InstrumentAxes? Axes { get; init; }

    /// <summary>The part of the detector that the camera is; null for all of it.</summary>
    public DetectorWindow? Window { get; init; }

    /// <summary>Keywords that say which pixels of the detector a product of some mode has.</summary>
    public string[] Modes { get; init; } = [];

    /// <summary>The one of them that must be there, because the formula counts from it; null for none.</summary>
    public string? CountsFrom { get; init; }

    /// <summary>All keywords that may turn rays, and are known here.</summary>
    public IReadOnlyCollection<string> Read => [.. Keywords, .. Modes];

    private static string[] WacModes =>
    [
        "FILTER_OFFSET", "COLOR_SAMPLE_OFFSET", "VIS_SAMPLE_OFFSET", "UV_SAMPLE_OFFSET", "BW0_SAMPLE_OFFSET", "BW1_SAMPLE_OFFSET",
        "BW2_SAMPLE_OFFSET", "BW3_SAMPLE_OFFSET",
    ];

    public static IReadOnlyList<InstrumentOptics> All { get; } =
    [
        new("LROC NAC", [-85600, -85610], "lro_lroc_v18.ti", ["OD_K"], Division) { IsLine = true },
        new("LROC WAC, visible", [-85631, -85632, -85633, -85634, -85635], "lro_lroc_v18.ti", ["OD_K"], Factor)
        {
            FirstPixel = 0.0,
            CountsFrom = "FILTER_OFFSET",
            Modes = WacModes,
        },
        new("LROC WAC, ultraviolet", [-85641, -85642], "lro_lroc_v18.ti", ["OD_K"], Factor)
        {
            FirstPixel = 0.0,
            Window = new("UV_SAMPLE_OFFSET", "FILTER_OFFSET", 512, 16),
            Modes = WacModes,
        },
        new(
            "Kaguya TC and MI",
            [-131351, -131371, -131331, -131332, -131333, -131334, -131335, -131341, -131342, -131343, -131344],
            "SEL_TC_V01.TI, SEL_MI_V01.TI", ["BORESIGHT", "DISTORTION_COEF_X", "DISTORTION_COEF_Y"], Kaguya)
        {
            Center = "CENTER",
            Pitch = "PIXEL_SIZE",
            IsLine = true,
            Axes = InstrumentAxes.Parse("-y,+x"),
        },
        new(
            "Clementine UVVIS", [-40021, -40022, -40023, -40024, -40025, -40026], "clem_uvvis_beta_ik_v04.ti", ["PP", "OD_K", "DECENTER"],
            Corrected),
        new("Chandrayaan-1 M3", [-86520], "m3Addendum005.ti, Chandrayaan1M3DistortionMap", ["PP", "OD_K", "DECENTER"], Corrected)
        {
            IsLine = true,
            Size = (608, 1),
        },
        new(
            "Apollo metric", [-915240, -916240, -917240], "apollo15_metric_v2.0001.ti, ApolloMetricDistortionMap",
            ["PP", "OD_K", "DECENTER"], Apollo)
        {
            Center = "CCD_CENTER",
        },
    ];

    /// <summary>The row of an instrument; null if the table has none.</summary>
    public static InstrumentOptics? Of(int instrument) => All.FirstOrDefault(row => row.Instruments.Contains(instrument));

    /// <summary>xc = xd / (1 + k1 r2).</summary>
    private static KernelLens Division(InstrumentKeywords keywords, FocalPlane plane) => new(
        keywords.Value("FOCAL_LENGTH"),
        Invariant($"distortion:\n  model: radial\n  form: division\n  k: [{keywords.Value("OD_K"):R}]\n"));

    /// <summary>xc = xd (1 + k1 r2 + k2 r4 + k3 r6).</summary>
    private static KernelLens Factor(InstrumentKeywords keywords, FocalPlane plane) => new(
        keywords.Value("FOCAL_LENGTH"), $"distortion:\n  model: radial\n  form: factor\n  k: [{List(keywords.Numbers("OD_K", 3))}]\n");

    /// <summary>
    /// v = BORESIGHT + (a(r), r + b(r), 0), r = -(n - CENTER) PIXEL_SIZE along +y. The comment of the kernel has a0 to a3 for y too; the
    /// text beside it says that these are b0 to b3, as ISIS and the preset have it.
    /// </summary>
    private static KernelLens Kaguya(InstrumentKeywords keywords, FocalPlane plane)
    {
        // Along a row r grows by right, x grows down by down.
        (double right, double down) = (plane.Right.Y, plane.Down.X);
        if (Math.Abs(Math.Abs(right) - 1.0) > 1e-9)
        {
            throw keywords.Wrong("ITRANSS", "is not along y, along which DISTORTION_COEF_X and DISTORTION_COEF_Y count");
        }

        double[] boresight = keywords.Numbers("BORESIGHT", 3);
        double[] x = Coefficients("DISTORTION_COEF_X", down);
        double[] y = Coefficients("DISTORTION_COEF_Y", right);
        x[0] += down * boresight[0];
        y[0] += right * boresight[1];
        return new KernelLens(
            boresight[2], $"distortion:\n  model: polynomial\n  argument: x\n  x: [{List(y)}]\n  y: [{List(x)}]\n");

        double[] Coefficients(string item, double sign)
        {
            IReadOnlyList<double> numbers = keywords.Find(item)?.Numbers ?? keywords.Numbers(item, 4);
            return numbers.Count is 3 or 4
                ? [.. numbers.Select((number, power) => sign * number * Math.Pow(right, power))]
                : throw keywords.Wrong(item, $"has {numbers.Count} numbers; 3 (MI-VIS) or 4 (TC, MI-NIR) are known");
        }
    }

    /// <summary>
    /// xu = xd + x (k1 + k2 r2 + k3 r4) + p1 (r2 + 2 x2) + 2 p2 x y, and so for y, with x = xd - xp.
    /// </summary>
    private static KernelLens Corrected(InstrumentKeywords keywords, FocalPlane plane)
    {
        double[] pp = keywords.Numbers("PP", 2);
        double[] p = keywords.Numbers("DECENTER", 2);
        (double right, double down) = plane.ToImage(pp[0], pp[1]);
        return new KernelLens(
            keywords.Value("FOCAL_LENGTH"),
            Brown(keywords.Numbers("OD_K", 3), plane.ToImage(p[0], p[1]), default, default)
                + Invariant($"  x0: {right:R}\n  y0: {down:R}\n"));
    }

    /// <summary>
    /// xu = x (1 + k1 r2 + k2 r4 + k3 r6) - sin(t0) (j1 r2 + j2 r4), yu = y (...) + cos(t0) (...), with x = xd - xp.
    /// </summary>
    private static KernelLens Apollo(InstrumentKeywords keywords, FocalPlane plane)
    {
        double[] pp = keywords.Numbers("PP", 2);
        double[] decenter = keywords.Numbers("DECENTER", 3);
        (double x, double y) = (-Math.Sin(decenter[2]), Math.Cos(decenter[2]));
        return new KernelLens(
            keywords.Value("FOCAL_LENGTH"),
            Brown(
                [0.0, .. keywords.Numbers("OD_K", 3)], default, plane.ToImage(decenter[0] * x, decenter[0] * y),
                plane.ToImage(decenter[1] * x, decenter[1] * y)),
            (pp[0], pp[1]));
    }

    private static string Brown(
        IEnumerable<double> k, (double Right, double Down) p, (double Right, double Down) square, (double Right, double Down) fourth) =>
        "distortion:\n  model: brown\n" + string.Concat(k.Select((number, i) => Invariant($"  k{i}: {number:R}\n")))
            + Invariant($"  p1: {p.Right:R}\n  p2: {p.Down:R}\n")
            + Invariant($"  s1: {square.Right:R}\n  s2: {fourth.Right:R}\n  s3: {square.Down:R}\n  s4: {fourth.Down:R}\n");

    private static string List(IEnumerable<double> numbers) => string.Join(", ", numbers.Select(number => Invariant($"{number:R}")));
}
