namespace Msisf.Benchmarks.Definitions;

/// <summary>What images of the native renderer have in common with POV-Ray's scenes, so that both can be compared.</summary>
internal static class PovRayScene
{
    /// <summary>Lambert albedo: a pigment of 0.8 and a diffuse part of 0.8.</summary>
    public const double Albedo = 0.64;
}
