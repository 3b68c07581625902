namespace Msisf.Core.Camera;

/// <summary>Where something lies relative to a <see cref="ViewFrustum"/>.</summary>
internal enum FrustumSide
{
    /// <summary>Certainly outside.</summary>
    Outside,

    /// <summary>Perhaps partly inside.</summary>
    Straddling,

    /// <summary>Wholly inside.</summary>
    Inside,
}
