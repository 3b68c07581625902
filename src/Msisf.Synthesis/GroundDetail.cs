using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// The ground of elevation models with invented detail below their resolution: roughness, craters and boulders from a seed
/// (docs/invented-detail.md). Safe for several threads.
/// </summary>
/// <remarks>
/// With the finest model that has data at a place, its samples S and the detail D below its resolution, the height is I(S - D) + D, where
/// I interpolates samples: so each sample keeps its height. Along borders it goes over into the same of the next coarser model.
/// </remarks>
public sealed class GroundDetail : IGroundDetail
{
    /// <summary>
    /// m: how far the ground may be beyond the models' samples; craters and hills below their resolution are lower than that.
    /// </summary>
    private const double MostDetail = 3000.0;

    // Limits of the factors of the reflectance, where many rays meet.
    private const float Darkest = 0.5f;
    private const float Brightest = 2.5f;

    private readonly MareMask _maria;
    private readonly ModelGround[] _grounds;
    private readonly ModelBorder?[] _borders;

    /// <summary>Prepares the ground: reads the coarsest model once, coarsely, for its maria and its slopes.</summary>
    /// <param name="seed">Another seed gives other detail.</param>
    /// <param name="models">The models, the coarsest first; that is one of the whole Moon.</param>
    /// <param name="cancellation">Stops the reading.</param>
    public GroundDetail(ulong seed, IReadOnlyList<ITerrainGrid> models, CancellationToken cancellation = default)
    {
        _maria = new MareMask((IGlobalGrid)models[0], cancellation);
        GroundMemory memory = new();
        _grounds = [.. models.Select(model => new ModelGround(model, seed, _maria, memory))];
        _borders = [.. models.Select((model, index) => index == 0 ? null : new ModelBorder(model, _grounds[index - 1].Spacing))];
        Name = Invariant($"REFINE_{seed}");
        RadiusLimits = (
            Math.Max(models.Min(model => model.RadiusLimits.Min) - MostDetail, MoonConstants.ReferenceRadius - MoonConstants.MaxRelief),
            Math.Min(models.Max(model => model.RadiusLimits.Max) + MostDetail, MoonConstants.ReferenceRadius + MoonConstants.MaxRelief));
    }

    /// <inheritdoc/>
    public string Name { get; }

    /// <inheritdoc/>
    public (double Min, double Max) RadiusLimits { get; }

    /// <inheritdoc/>
    public void ReadRadii(PolarStereographic map, int firstLine, int firstSample, int side, Span<double> radii)
    {
        (MapFrame frame, float[] maria) = BlockOf(map, firstLine, firstSample, side);
        float[] detail = new float[maria.Length];
        double[] heights = Heights(GroundPoints.Of(frame), map.MetresPerPixel, layer =>
        {
            Array.Clear(detail);
            layer.AddTo(frame, maria, detail);
            return detail;
        });
        for (int line = 0; line < side; line++)
        {
            for (int sample = 0; sample < side; sample++)
            {
                radii[(line * side) + sample] = RadiusOf(heights[(line * frame.Stride) + sample]);
            }
        }
    }

    /// <inheritdoc/>
    public void ReadBrightness(PolarStereographic map, int firstLine, int firstSample, int side, Span<float> factors)
    {
        (MapFrame frame, float[] maria) = BlockOf(map, firstLine, firstSample, side);
        float[] sums = new float[maria.Length];
        float[] own = new float[maria.Length];
        foreach ((ModelGround ground, double[] weights) in CountingAt(GroundPoints.Of(frame)))
        {
            ground.LayerOf(map.MetresPerPixel).FindBrightness(frame, maria, own);
            for (int i = 0; i < own.Length; i++)
            {
                sums[i] += (float)weights[i] * (own[i] - sums[i]);
            }
        }

        for (int line = 0; line < side; line++)
        {
            for (int sample = 0; sample < side; sample++)
            {
                factors[(line * side) + sample] = Math.Clamp(sums[(line * frame.Stride) + sample], Darkest, Brightest);
            }
        }
    }

    /// <inheritdoc/>
    public double RadiusAt(Vector3D direction, double cell)
    {
        GroundPoints point = GroundPoints.Of(direction);
        float mare = (float)_maria.At(point.Latitudes[0], point.Longitudes[0]);
        return RadiusOf(Heights(point, cell, layer => [(float)layer.At(direction, mare)])[0]);
    }

    private (MapFrame Frame, float[] MareFraction) BlockOf(PolarStereographic map, int firstLine, int firstSample, int side)
    {
        double maxShift = side % MapFrame.WholeSteps == 0 ? MapFrame.LeastShift(map.MetresPerPixel) : 0.0;
        MapFrame frame = new(map, firstLine, side, firstSample, side, maxShift);
        float[] maria = new float[frame.X.Length];
        _maria.Fill(frame, maria);
        return (frame, maria);
    }

    private double RadiusOf(double height) =>
        Math.Clamp(MoonConstants.ReferenceRadius + height, RadiusLimits.Min, RadiusLimits.Max);

    /// <summary>Heights over the reference radius, m.</summary>
    /// <param name="points">The places.</param>
    /// <param name="cell">m: width of the cells.</param>
    /// <param name="detailOf">Computes the detail of a layer at the places, m.</param>
    private double[] Heights(GroundPoints points, double cell, Func<DetailLayer, float[]> detailOf)
    {
        double[] heights = new double[points.Count];
        double[] own = new double[points.Count];
        foreach ((ModelGround ground, double[] weights) in CountingAt(points))
        {
            ground.Interpolate(points, weights, cell, own);
            float[] detail = detailOf(ground.LayerOf(cell));
            for (int i = 0; i < heights.Length; i++)
            {
                double weight = weights[i];
                heights[i] = weight > 0.0 ? (weight * (own[i] + detail[i])) + ((1.0 - weight) * heights[i]) : heights[i];
            }
        }

        return heights;
    }

    /// <summary>
    /// The models that count anywhere, the coarsest first, and of those none under one that counts fully everywhere; with what they count.
    /// </summary>
    private List<(ModelGround Ground, double[] Weights)> CountingAt(GroundPoints points)
    {
        List<(ModelGround Ground, double[] Weights)> counting = [];
        for (int model = _grounds.Length - 1; model >= 0; model--)
        {
            double[] weights = WeightsOf(model, points);
            if (Array.Exists(weights, weight => weight > 0.0))
            {
                counting.Add((_grounds[model], weights));
            }

            if (Array.TrueForAll(weights, weight => weight == 1.0))
            {
                break;
            }
        }

        counting.Reverse();
        return counting;
    }

    private double[] WeightsOf(int model, GroundPoints points)
    {
        double[] weights = new double[points.Count];
        for (int i = 0; i < weights.Length; i++)
        {
            if (_borders[model] is { } border)
            {
                (double line, double sample) = _grounds[model].PixelOf(points, i);
                weights[i] = border.WeightAt(line, sample);
            }
            else
            {
                weights[i] = 1.0;
            }
        }

        return weights;
    }
}

/// <summary>The craters and boulders of a seed that were found, for all layers of detail. Safe for several threads.</summary>
internal sealed class GroundMemory
{
    /// <summary>The craters of all diameters, also those that a layer does not have.</summary>
    public CellMemory<PlacedCrater> Craters { get; } = new();

    /// <summary>The rays of fresh craters.</summary>
    public CellMemory<CraterRays> Rays { get; } = new();

    /// <summary>The boulders.</summary>
    public CellMemory<Boulder> Boulders { get; } = new();
}
