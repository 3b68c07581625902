using Msisf.Core.Preview;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;

namespace Msisf.App.DataSets;

/// <summary>The state of one image of a data set, and what was drawn for it.</summary>
/// <param name="Split">Name of its split.</param>
/// <param name="Candidate">Number of the point of the unit cube that it comes from, from 0 in each split.</param>
/// <param name="Region">The region that its place was drawn in.</param>
/// <param name="Drawn">The drawn numbers; both images of a pair have the same.</param>
internal sealed record DrawnState(
    string Split, long Candidate, Region Region, IReadOnlyDictionary<Quantity, double> Drawn, SpacecraftState State)
{
    /// <summary>The part of the image that shows ground.</summary>
    public double Ground { get; init; }

    /// <summary>The part of that ground that gets light.</summary>
    public double Lit { get; init; }

    /// <summary>Where the Sun stands over the ground below the camera.</summary>
    public SkyDirection Sun { get; init; }

    /// <summary>The point below the camera.</summary>
    public SelenographicPoint Place => SelenographicPoint.Below(State.PositionBodyFixed);
}
