namespace Msisf.Core.Navigation;

/// <summary>What a frame says for navigation, beside its pixels.</summary>
public sealed record NavigationTruth
{
    /// <summary>The craters of the catalogue; null without one.</summary>
    public CratersOfFrame? Craters { get; init; }

    /// <summary>The landmarks of the list; null without one.</summary>
    public LandmarksOfFrame? Landmarks { get; init; }
}
