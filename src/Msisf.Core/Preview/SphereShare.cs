namespace Msisf.Core.Preview;

/// <summary>How much of an image shows a sphere, and how much of that is lit.</summary>
/// <param name="Moon">Part of the image's area that shows the sphere, 0 to 1.</param>
/// <param name="Lit">Part of <paramref name="Moon"/> in which the light stands above the horizon, 0 to 1; null if Moon is 0.</param>
public readonly record struct SphereShare(double Moon, double? Lit);
