namespace Msisf.Core.Render.Shading;

/// <summary>How a sample of each pixel counts.</summary>
/// <param name="Share">Its part of the sum; 0 to find its light only.</param>
/// <param name="IsFirst">Whether it is the first of the sum; what the image held before is then forgotten.</param>
internal readonly record struct SampleWeight(double Share, bool IsFirst);
