using Msisf.Core.Render;

namespace Msisf.Cli.Pieces;

/// <summary>
/// What a frame costs, from what it shows: seconds on one core of the computer that the coefficients were measured on. Only ratios
/// between frames of one run matter for cutting it. Measured as docs/scaling.md says; the fits are by minimum squares over frames.
/// </summary>
/// <param name="Fixed">s a frame, whatever it shows: files, and with POV-Ray its process.</param>
/// <param name="PerSample">s a sample of the image.</param>
/// <param name="PerFace">s a triangle of the tiles that the image needs, at its level of detail.</param>
internal readonly record struct FrameCost(double Fixed, double PerSample, double PerFace)
{
    /// <summary>147 frames of 512 x 512 px of an eccentric orbit on LDEM_64: docs/benchmark/frame-times.csv, correlation 0.82 with the times.</summary>
    private static readonly FrameCost Native = new(Fixed: 0.0, PerSample: 1.57e-7, PerFace: 1.19e-8);

    /// <summary>
    /// 14 scenes of 1024 x 1024 px on models of 4 to 512 px/deg: the rows "povray" of docs/benchmark/front.csv, 1.755 s + 4.66e-6 s a triangle, of which
    /// 0.8 s are neither POV-Ray's parsing nor its tracing. Correlation 0.96 with the times of 38 other frames (frame-times.csv).
    /// </summary>
    private static readonly FrameCost PovRay = new(Fixed: 0.8, PerSample: 9.1e-7, PerFace: 4.7e-6);

    /// <summary>The costs of a renderer's frames.</summary>
    public static FrameCost Of(RendererKind renderer) => renderer == RendererKind.Native ? Native : PovRay;

    /// <summary>The estimate for a frame.</summary>
    /// <param name="samples">Samples of the image.</param>
    /// <param name="faces">Triangles of its tiles.</param>
    public double Seconds(long samples, long faces) => Fixed + (PerSample * samples) + (PerFace * faces);
}
