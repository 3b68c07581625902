using System.Runtime.CompilerServices;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;

namespace Msisf.Core.Navigation;

/// <summary>The craters of a run. Heights of the ground are kept from frame to frame. Thread-safe.</summary>
public sealed class CraterCatalogue
{
    private readonly Vector3D[] _directions;
    private readonly ConditionalWeakTable<ITerrain, double[]> _radii = [];

    /// <summary>Takes the craters.</summary>
    public CraterCatalogue(IReadOnlyList<Crater> craters)
    {
        Craters = craters;
        _directions = [.. craters.Select(crater => CraterDisc.Of(crater, 1.0).Up)];
        MaxRadius = craters.Count == 0 ? 0.0 : 0.5 * craters.Max(crater => crater.Diameter);
    }

    /// <summary>In the order of the catalogue.</summary>
    public IReadOnlyList<Crater> Craters { get; }

    /// <summary>m: of the largest.</summary>
    public double MaxRadius { get; }

    /// <summary>From the Moon's centre to the centres of the craters, length 1, body-fixed.</summary>
    internal ReadOnlySpan<Vector3D> Directions => _directions;

    /// <summary>The disc of a crater's rim on a terrain.</summary>
    /// <param name="index">In <see cref="Craters"/>.</param>
    /// <param name="terrain">The terrain that a frame shows.</param>
    public CraterDisc DiscOf(int index, ITerrain terrain)
    {
        double[] radii = _radii.GetValue(terrain, _ => new double[Craters.Count]);
        double radius = radii[index];
        if (radius == 0.0)
        {
            // Two threads may both compute it; they get the same.
            radius = TerrainHeight.RadiusBelow(terrain, _directions[index]);
            radii[index] = radius;
        }

        return CraterDisc.Of(Craters[index], radius);
    }
}
