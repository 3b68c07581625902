using System.Runtime.CompilerServices;
using Msisf.Core.Terrain;

namespace Msisf.Core.Navigation;

/// <summary>The craters of a run. Heights of the ground are kept from frame to frame. Thread-safe.</summary>
public sealed class CraterCatalogue(IReadOnlyList<Crater> craters)
{
    private readonly Vector3D[] _directions = [.. craters.Select(crater => CraterDisc.Of(crater, 1.0).Up)];
    private readonly ConditionalWeakTable<ITerrain, KnownGround> _grounds = [];

    /// <summary>In the order of the catalogue.</summary>
    public IReadOnlyList<Crater> Craters { get; } = craters;

    /// <summary>From the Moon's centre to the centres of the craters, length 1, body-fixed.</summary>
    internal ReadOnlySpan<Vector3D> Directions => _directions;

    /// <summary>The disc of a crater's rim on a terrain.</summary>
    /// <param name="index">In <see cref="Craters"/>.</param>
    public CraterDisc DiscOf(int index, ITerrain terrain)
    {
        KnownGround known = KnownOf(terrain);
        double radius = known.Radii[index];
        if (radius == 0.0)
        {
            // Two threads may both compute it; they get the same.
            radius = known.Ground.RadiusAt(_directions[index]);
            known.Radii[index] = radius;
        }

        return CraterDisc.Of(Craters[index], radius);
    }

    /// <summary>The ground of a terrain.</summary>
    internal GroundBelow GroundOf(ITerrain terrain) => KnownOf(terrain).Ground;

    private KnownGround KnownOf(ITerrain terrain) =>
        _grounds.GetValue(terrain, shown => new KnownGround(new GroundBelow(shown), new double[Craters.Count]));

    /// <summary>The ground of a terrain, and what is known of it: m from the Moon's centre to each crater's, 0 for not yet.</summary>
    private sealed record KnownGround(GroundBelow Ground, double[] Radii);
}

/// <summary>A crater of a catalogue: an ellipse on the ground, of most catalogues a circle. Immutable.</summary>
/// <param name="Number">The catalogue's row, from 1, without its heading.</param>
/// <param name="Identity">The catalogue's own name of the row, its number where there is none; no two are the same.</param>
/// <param name="Name">Null where the catalogue has none.</param>
/// <param name="LatitudeDegrees">Planetocentric, [-90, 90].</param>
/// <param name="LongitudeDegrees">East, [0, 360).</param>
/// <param name="Diameter">m: the major axis.</param>
public sealed record Crater(int Number, string Identity, string? Name, double LatitudeDegrees, double LongitudeDegrees, double Diameter)
{
    /// <summary>m: the minor axis; of a circle the same.</summary>
    public double MinorDiameter { get; init; } = Diameter;

    /// <summary>Direction of the major axis, degrees from east towards north.</summary>
    public double AngleDegrees { get; init; }

    /// <summary>Standard deviations; null where the catalogue has none.</summary>
    public CraterErrors? Errors { get; init; }
}

/// <summary>Standard deviations of a catalogue's crater, taken as independent.</summary>
/// <param name="LatitudeDegrees">Degrees.</param>
/// <param name="LongitudeDegrees">Degrees.</param>
/// <param name="Diameter">m.</param>
/// <param name="MinorDiameter">m.</param>
/// <param name="AngleDegrees">Degrees.</param>
public sealed record CraterErrors(
    double LatitudeDegrees, double LongitudeDegrees, double Diameter, double MinorDiameter, double AngleDegrees);
