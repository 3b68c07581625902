using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// The ground of elevation models with invented detail below their resolution: roughness, craters and boulders from a seed
/// (docs/invented-detail.md). Safe for several threads.
/// </summary>
/// <remarks>
/// With the finest model that has data at a place, its samples S and the detail D below its resolution, the height is I(S - D) + D, where
/// I interpolates samples: so each sample keeps its height. Beyond a map's border the same of the next coarser model goes on, changed so
/// that it meets the map (<see cref="BorderGround"/>).
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
    private readonly BorderGround?[] _borders;

    /// <summary>Prepares the ground: reads the coarsest model once, coarsely, for its maria and its slopes.</summary>
    /// <param name="seed">Another seed gives other detail.</param>
    /// <param name="models">The models, the coarsest first; that is one of the whole Moon.</param>
    /// <param name="cancellation">Stops the reading.</param>
    public GroundDetail(ulong seed, IReadOnlyList<ITerrainGrid> models, CancellationToken cancellation = default)
    {
        _maria = new MareMask((IGlobalGrid)models[0], cancellation);
        GroundMemory memory = new();
        _borders = [.. models.Select((model, index) => index == 0 ? null
            : new BorderGround(model, (direction, cell) => HeightAt(direction, cell, models: index)))];
        _grounds = [.. models.Select((model, index) => new ModelGround(model, seed, _maria, memory, _borders[index]))];
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
        double[] heights = Heights(GroundPoints.Of(frame), map.MetresPerPixel, _grounds.Length, layer =>
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
        foreach ((int model, double[] weights) in CountingAt(GroundPoints.Of(frame), _grounds.Length))
        {
            if (!Array.Exists(weights, weight => weight > 0.0))
            {
                continue;
            }

            _grounds[model].LayerOf(map.MetresPerPixel).FindBrightness(frame, maria, own);
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
    public double RadiusAt(Vector3D direction, double cell) => RadiusOf(HeightAt(direction, cell, _grounds.Length));

    /// <summary>m over the reference radius: the ground of the coarsest models.</summary>
    /// <param name="models">How many of them.</param>
    private double HeightAt(Vector3D direction, double cell, int models)
    {
        GroundPoints point = GroundPoints.Of(direction);
        float mare = (float)_maria.At(point.Latitudes[0], point.Longitudes[0]);
        return Heights(point, cell, models, layer => [(float)layer.At(direction, mare)])[0];
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
    /// <param name="models">How many models count, the coarsest first.</param>
    /// <param name="detailOf">Computes the detail of a layer at the places, m.</param>
    private double[] Heights(GroundPoints points, double cell, int models, Func<DetailLayer, float[]> detailOf)
    {
        double[] heights = new double[points.Count];
        double[] own = new double[points.Count];
        foreach ((int model, double[] weights) in CountingAt(points, models))
        {
            ChangeAround(model, points, weights, heights);
            if (!Array.Exists(weights, weight => weight > 0.0))
            {
                continue;
            }

            ModelGround ground = _grounds[model];
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

    /// <summary>Changes the ground beyond a map's border so that it meets the map.</summary>
    private void ChangeAround(int model, GroundPoints points, double[] weights, double[] heights)
    {
        for (int i = 0; i < heights.Length && _borders[model] is not null; i++)
        {
            heights[i] += weights[i] < 1.0 ? _borders[model]!.ChangeAt(points[i]) : 0.0;
        }
    }

    /// <summary>
    /// The models that count anywhere, the coarsest first, with what they count: of these none under one that counts fully everywhere, and
    /// also those that only change the ground around them.
    /// </summary>
    private List<(int Model, double[] Weights)> CountingAt(GroundPoints points, int models)
    {
        List<(int Model, double[] Weights)> counting = [];
        (Vector3D middle, double around) = BallOf(points);
        for (int model = models - 1; model >= 0; model--)
        {
            double[] weights = WeightsOf(model, points);
            if (Array.Exists(weights, weight => weight > 0.0) || _borders[model]?.IsNear(middle, around) == true)
            {
                counting.Add((model, weights));
            }

            if (Array.TrueForAll(weights, weight => weight == 1.0))
            {
                break;
            }
        }

        counting.Reverse();
        return counting;
    }

    /// <summary>Direction of about the middle of places, and m: none of them is farther away.</summary>
    private static (Vector3D Middle, double Around) BallOf(GroundPoints points)
    {
        Vector3D middle = points[points.Count / 2];
        double squared = 0.0;
        for (int i = 0; i < points.Count; i++)
        {
            squared = Math.Max(squared, (points[i] - middle).LengthSquared);
        }

        return (middle, MoonConstants.ReferenceRadius * Math.Sqrt(squared));
    }

    private double[] WeightsOf(int model, GroundPoints points)
    {
        double[] weights = new double[points.Count];
        for (int i = 0; i < weights.Length; i++)
        {
            if (_borders[model] is { } beyond)
            {
                (double line, double sample) = _grounds[model].PixelOf(points, i);
                weights[i] = beyond.Border.WeightAt(line, sample);
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
