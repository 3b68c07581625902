namespace Msisf.Adapters.Illumination;

/// <summary>A map of one number a cell.</summary>
/// <param name="Name">Small letters; of files and layers.</param>
/// <param name="Unit">Unit, empty for none.</param>
/// <param name="Meaning">One sentence.</param>
/// <param name="Values">Line by line from the top; NaN where there are no data.</param>
public sealed record LightMap(string Name, string Unit, string Meaning, float[] Values)
{
    /// <summary>m over the ground.</summary>
    public required double Height { get; init; }
}

/// <summary>What the times of maps are.</summary>
/// <param name="Start">UTC.</param>
/// <param name="End">UTC.</param>
/// <param name="StepHours">From one time to the next.</param>
/// <param name="Sun">disc or point.</param>
public sealed record MapTimes(string Start, string End, double StepHours, string Sun);
