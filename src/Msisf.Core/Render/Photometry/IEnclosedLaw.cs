namespace Msisf.Core.Render.Photometry;

/// <summary>A law whose values and slopes can be enclosed over ranges of the angles.</summary>
internal interface IEnclosedLaw
{
    /// <summary>Encloses the radiance factor and its three derivatives.</summary>
    /// <param name="cosIncidence">Above 0, up to 1.</param>
    /// <param name="cosEmission">Above 0, up to 1.</param>
    /// <param name="phaseHaversine">0 to 1.</param>
    Sloped Enclose(in Sloped cosIncidence, in Sloped cosEmission, in Sloped phaseHaversine);
}
