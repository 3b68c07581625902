using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// The detail below a model's resolution that cells of a width can show: noise, craters and boulders, all of which a layer for wider cells
/// leaves out or has as they are here. Safe for several threads.
/// </summary>
internal sealed class DetailLayer
{
    /// <summary>Minimum diameter of a crater, and length of a boulder, in cells.</summary>
    private const double SmallestInCells = 4.0;

    /// <summary>Maximum diameter of a crater in samples of the model, which shows larger ones itself.</summary>
    private const double LargestInSamples = 2.0;

    private readonly NoiseOctave[] _octaves;
    private readonly CraterPopulation _craters;
    private readonly BoulderPopulation _boulders;
    private readonly RayPopulation _rays;

    /// <summary>Prepares a layer.</summary>
    /// <param name="seed">The user's seed.</param>
    /// <param name="maria">Where the ground is smoother.</param>
    /// <param name="slopes">The model's slopes.</param>
    /// <param name="modelSpacing">m between the model's samples.</param>
    /// <param name="cell">m: width of the cells, a power of two.</param>
    /// <param name="memory">Keeps what layers find.</param>
    public DetailLayer(ulong seed, MareMask maria, ModelSlopes slopes, double modelSpacing, double cell, GroundMemory memory)
    {
        // The lattices of the noise, and the limits of diameters, are powers of two, so that they are the same below every model.
        double widest = Math.ScaleB(1.0, (int)Math.Floor(Math.Log2(modelSpacing)));
        _octaves = DetailSpectrum.Octaves(seed, widest, cell, slopes, CraterLaw.Published);
        _craters = new CraterPopulation(
            seed, maria, SmallestInCells * cell, LargestInSamples * widest, CraterLaw.Published, memory.Craters);
        _boulders = new BoulderPopulation(seed, SmallestInCells * cell, _craters, memory.Boulders);
        _rays = new RayPopulation(_craters, CraterLaw.Published, memory.Rays);
    }

    /// <summary>Adds the detail to a block.</summary>
    /// <param name="frame">The block.</param>
    /// <param name="mareFraction">0 (highlands) to 1 (mare) at the frame's samples.</param>
    /// <param name="heights">m, as the frame's directions.</param>
    public void AddTo(MapFrame frame, ReadOnlySpan<float> mareFraction, Span<float> heights)
    {
        foreach (NoiseOctave octave in _octaves)
        {
            octave.AddTo(frame.X, frame.Y, frame.Z, mareFraction, heights);
        }

        (double south, double north, double west, double width) = frame.Around();
        foreach (PlacedCrater crater in _craters.PlacedNear(south, north, west, width))
        {
            CraterStamp.AddTo(crater, frame, heights);
        }

        foreach (Boulder boulder in _boulders.Near(south, north, west, width))
        {
            AddTo(boulder, frame, heights);
        }
    }

    /// <inheritdoc cref="RayPopulation.Find"/>
    public void FindBrightness(MapFrame frame, ReadOnlySpan<float> mareFraction, Span<float> factors) =>
        _rays.Find(frame, mareFraction, factors);

    /// <summary>The detail in a direction, m.</summary>
    /// <param name="direction">Unit vector, body-fixed.</param>
    /// <param name="mareFraction">0 (highlands) to 1 (mare).</param>
    public double At(Vector3D direction, float mareFraction)
    {
        Span<double> x = stackalloc double[TileFrame.VectorWidth];
        Span<double> y = stackalloc double[TileFrame.VectorWidth];
        Span<double> z = stackalloc double[TileFrame.VectorWidth];
        Span<float> maria = stackalloc float[TileFrame.VectorWidth];
        Span<float> heights = stackalloc float[TileFrame.VectorWidth];
        x.Fill(direction.X);
        y.Fill(direction.Y);
        z.Fill(direction.Z);
        maria.Fill(mareFraction);
        heights.Clear();
        AddTo(x, y, z, direction, 0.0, maria, heights);
        return heights[0];
    }

    /// <summary>Adds the detail at places near each other.</summary>
    /// <param name="x">x of their directions, body-fixed; a multiple of <see cref="TileFrame.VectorWidth"/> of them.</param>
    /// <param name="y">y of the directions.</param>
    /// <param name="z">z of the directions.</param>
    /// <param name="middle">Direction in the middle of them.</param>
    /// <param name="farthest">How far the farthest is from it, radii of the Moon.</param>
    /// <param name="mareFraction">0 (highlands) to 1 (mare).</param>
    /// <param name="heights">m.</param>
    public void AddTo(
        ReadOnlySpan<double> x, ReadOnlySpan<double> y, ReadOnlySpan<double> z, Vector3D middle, double farthest,
        ReadOnlySpan<float> mareFraction, Span<float> heights)
    {
        foreach (NoiseOctave octave in _octaves)
        {
            octave.AddTo(x, y, z, mareFraction, heights);
        }

        (double south, double north, double west, double width) = GroundPoints.Around(middle, 1.01 * farthest); // of a chord and its angle
        foreach (PlacedCrater crater in _craters.PlacedNear(south, north, west, width))
        {
            if ((crater.Direction - middle).Length <= (Crater.Reach * crater.Radius) + farthest)
            {
                CraterStamp.AddTo(crater, x, y, z, heights, lines: 1, heights.Length, heights.Length);
            }
        }

        foreach (Boulder boulder in _boulders.Near(south, north, west, width))
        {
            for (int i = 0; i < heights.Length; i++)
            {
                heights[i] += (float)boulder.HeightAt(new Vector3D(x[i], y[i], z[i]));
            }
        }
    }

    private static void AddTo(Boulder boulder, MapFrame frame, Span<float> heights)
    {
        double reach = boulder.Radius / MoonConstants.ReferenceRadius;
        if (CraterStamp.Reached(boulder.Centre, reach, frame) is not { } reached)
        {
            return;
        }

        for (int line = reached.FirstLine; line <= reached.LastLine; line++)
        {
            for (int sample = reached.FirstSample; sample <= Math.Min(reached.LastSample, frame.Samples - 1); sample++)
            {
                int at = (line * frame.Stride) + sample;
                heights[at] += (float)boulder.HeightAt(new Vector3D(frame.X[at], frame.Y[at], frame.Z[at]));
            }
        }
    }
}
