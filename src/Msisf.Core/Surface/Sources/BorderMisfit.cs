using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>How far a model's own ground is off that of the coarser models along its border, before any of them is changed.</summary>
/// <param name="ProductId">Name of the model.</param>
/// <param name="Height">m: the model's height less that of the coarser ones.</param>
/// <param name="Slope">
/// Tangents: how much more steeply the model rises from its border inwards than the ground of the coarser ones.
/// </param>
public readonly record struct BorderMisfit(string ProductId, MisfitNumbers Height, MisfitNumbers Slope)
{
    /// <summary>m: how far into the coarser model the difference is carried, or the model itself is bent.</summary>
    public double BlendedMetres { get; init; }

    /// <summary>Samples over which the slope is taken, where the model has as many: fewer have its roughness, not its trend.</summary>
    public const int SlopeSamples = 64;

    /// <summary>Compares a model's outermost samples, also those around places without data.</summary>
    /// <param name="coarserAt">m: radius of the coarser models in a direction; null where there is none.</param>
    /// <returns>Null if the coarser models are nowhere below the border.</returns>
    internal static BorderMisfit? Of(ITerrainGrid model, Outline outline, Func<Vector3D, double?> coarserAt)
    {
        GridWindow window = model.Window;
        int inwards = Math.Clamp(Math.Min(window.Lines, window.Samples) / 4, 1, SlopeSamples);
        (MisfitSums heights, MisfitSums slopes) = (default, default);
        foreach (OutlineSample sample in outline.Samples)
        {
            if (coarserAt(sample.Direction) is not { } below)
            {
                continue;
            }

            double misfit = sample.Radius - below;
            heights = heights.With(misfit, sample.Count);
            if (Inside(model, sample, inwards) is (Vector3D direction, double radius) && coarserAt(direction) is { } belowInside)
            {
                double rise = radius - belowInside - misfit;
                slopes = slopes.With(
                    rise / (MoonConstants.ReferenceRadius * (direction - sample.Direction).Length), sample.Count);
            }
        }

        return heights.Count == 0.0 ? null : new BorderMisfit(model.ProductId, heights.Numbers, slopes.Numbers);
    }

    /// <summary>A place with data, so many samples from an outermost one away from where there is none; null if there is no such.</summary>
    private static (Vector3D Direction, double Radius)? Inside(ITerrainGrid model, OutlineSample from, int samples)
    {
        GridWindow window = model.Window;
        bool[] isGap = new bool[1];
        double[] radius = new double[1];
        foreach ((int down, int right) in (ReadOnlySpan<(int, int)>)[(0, 1), (1, 0), (0, -1), (-1, 0)])
        {
            (int line, int sample) = (from.Line + (down * samples), from.Sample + (right * samples));
            if (!HasData(from.Line - down, from.Sample - right) && HasData(line, sample))
            {
                model.ReadRadii(line, sample, radius);
                return (model.Projection.DirectionOf(line, sample), radius[0]);
            }
        }

        return null;

        bool HasData(int line, int sample)
        {
            bool isIn = line >= window.FirstLine && line < window.EndLine && sample >= window.FirstSample && sample < window.EndSample;
            if (isIn)
            {
                model.ReadGaps(line, sample, isGap);
            }

            return isIn && !isGap[0];
        }
    }

    /// <summary>Sums of misfits.</summary>
    private readonly record struct MisfitSums(double Count, double Sum, double Squares, double Greatest)
    {
        public MisfitNumbers Numbers => new(Sum / Math.Max(1.0, Count), Math.Sqrt(Squares / Math.Max(1.0, Count)), Greatest);

        public MisfitSums With(double misfit, double count) => new(
            Count + count, Sum + (count * misfit), Squares + (count * misfit * misfit),
            Math.Abs(misfit) > Math.Abs(Greatest) ? misfit : Greatest);
    }
}

/// <summary>Numbers that tell how large misfits are.</summary>
/// <param name="Rms">The root of their mean square.</param>
/// <param name="Greatest">The one that is farthest from 0.</param>
public readonly record struct MisfitNumbers(double Mean, double Rms, double Greatest);
