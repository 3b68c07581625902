using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// Computes blocks of a polar map of a <see cref="SyntheticTerrain"/>: the ground that <see cref="TileSynthesizer"/> gives to a model of
/// latitude and longitude, at other places. Belongs to one thread; a sample's height does not depend on the block.
/// </summary>
/// <param name="terrain">The ground, of <see cref="SyntheticTerrain.ForMap"/>.</param>
/// <param name="projection">The map.</param>
public sealed class MapSynthesizer(SyntheticTerrain terrain, PolarStereographic projection)
{
    private float[] _maria = [];
    private float[] _detail = [];

    /// <summary>Computes one block.</summary>
    /// <param name="firstLine">Top line.</param>
    /// <param name="lines">How many lines.</param>
    /// <param name="firstSample">Leftmost sample.</param>
    /// <param name="samples">How many samples.</param>
    /// <param name="heights">Filled with m over the reference radius, line by line.</param>
    public void Synthesize(int firstLine, int lines, int firstSample, int samples, Span<float> heights)
    {
        MapFrame frame = new(projection, firstLine, lines, firstSample, samples);
        int length = frame.X.Length;
        if (_detail.Length < length)
        {
            _detail = new float[length];
            _maria = new float[length];
        }

        Span<float> detail = _detail.AsSpan(0, length);
        Span<float> maria = _maria.AsSpan(0, length);
        detail.Clear();
        for (int index = 0; index < length; index++)
        {
            maria[index] = (float)terrain.Maria.At(frame.Latitudes[index], frame.Longitudes[index]);
        }

        foreach (NoiseOctave octave in terrain.Octaves)
        {
            octave.AddTo(frame.X, frame.Y, frame.Z, maria, detail);
        }

        (double south, double north) = frame.LatitudeRange;
        foreach (Crater crater in terrain.CratersNear(south, north, frame.West, frame.Width))
        {
            MapCraterStamp.AddTo(new PlacedCrater(crater), frame, detail);
        }

        MapBase ground = new(terrain, south, north);
        for (int line = 0; line < lines; line++)
        {
            for (int sample = 0; sample < samples; sample++)
            {
                int index = (line * frame.Stride) + sample;
                heights[(line * samples) + sample] =
                    (float)(ground.HeightAt(frame.Latitudes[index], frame.Longitudes[index]) + detail[index]);
            }
        }
    }
}
