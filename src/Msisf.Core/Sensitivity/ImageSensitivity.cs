namespace Msisf.Core.Sensitivity;

/// <summary>The derivatives of an image's signal.</summary>
/// <param name="Field">Derivatives of electrons with a detector, otherwise of radiance factors.</param>
/// <param name="Signal">"electron", or empty for radiance factors.</param>
/// <param name="InformationOf">What the image tells of some parameters; null without a detector, whose noise is not known.</param>
public sealed record ImageSensitivity(
    SensitivityField Field, string Signal, Func<IReadOnlyList<Parameter>, FisherInformation>? InformationOf);
