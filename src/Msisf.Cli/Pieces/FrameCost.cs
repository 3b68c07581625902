using Msisf.Cli.Options;
using Msisf.Core.Render;

namespace Msisf.Cli.Pieces;

/// <summary>
/// What a frame costs, from what it shows: seconds on one core of the computer that the coefficients were measured on. Only ratios
/// between frames of one run matter for cutting it. Measured as docs/scaling.md says; the fits are by least squares over frames.
/// </summary>
/// <param name="Fixed">s a frame, whatever it shows: files, and with POV-Ray its process.</param>
/// <param name="PerSample">s a sample of the picture.</param>
/// <param name="PerFace">s a triangle of the tiles that the picture needs, at its level of detail.</param>
internal readonly record struct FrameCost(double Fixed, double PerSample, double PerFace)
{
    private static readonly FrameCost Native = new(Fixed: 0.0, PerSample: 1.3e-7, PerFace: 1.2e-8);

    private static readonly FrameCost PovRay = new(Fixed: 0.7, PerSample: 3.0e-6, PerFace: 2.0e-6);

    /// <summary>The costs of a renderer's frames.</summary>
    public static FrameCost Of(RenderSettings settings) => settings.Renderer == RendererKind.Native ? Native : PovRay;

    /// <summary>The estimate for a frame.</summary>
    /// <param name="samples">Samples of the picture.</param>
    /// <param name="faces">Triangles of its tiles.</param>
    public double Seconds(long samples, long faces) => Fixed + (PerSample * samples) + (PerFace * faces);
}
