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
            CraterStamp.AddTo(new PlacedCrater(crater), frame, detail);
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

/// <summary>The base model between two latitudes, interpolated at any place as <see cref="BaseSurface"/> does at samples.</summary>
internal sealed class MapBase
{
    private const int Reach = PixelMeanKernel.Reach;

    private readonly int _pixelsPerDegree;
    private readonly int _firstLine;
    private readonly MeanSpline _spline;

    /// <summary>Reads the base's lines, all around the Moon.</summary>
    /// <param name="terrain">The ground.</param>
    /// <param name="southDegrees">Southernmost latitude.</param>
    /// <param name="northDegrees">Northernmost latitude.</param>
    public MapBase(SyntheticTerrain terrain, double southDegrees, double northDegrees)
    {
        _pixelsPerDegree = terrain.Base.PixelsPerDegree;
        int around = 360 * _pixelsPerDegree;
        _firstLine = LineOf(northDegrees);
        int lines = LineOf(southDegrees) - _firstLine + 1;
        int all = around + (2 * Reach);
        double[] means = new double[(lines + (2 * Reach)) * all];
        for (int line = 0; line < lines + (2 * Reach); line++)
        {
            Span<double> own = means.AsSpan(line * all, all);
            terrain.Base.ReadHeights(_firstLine - Reach + line, 0, own.Slice(Reach, around));
            own.Slice(around, Reach).CopyTo(own);
            own.Slice(Reach, Reach).CopyTo(own[(around + Reach)..]);
        }

        _spline = new MeanSpline(means, lines, around, terrain.Kernel);
    }

    /// <summary>Height at a place, m over the reference radius.</summary>
    /// <param name="latitudeDegrees">Between the latitudes that were read.</param>
    /// <param name="longitudeDegrees">[0, 360).</param>
    public double HeightAt(double latitudeDegrees, double longitudeDegrees) =>
        _spline.HeightAt(((90.0 - latitudeDegrees) * _pixelsPerDegree) - _firstLine, longitudeDegrees * _pixelsPerDegree);

    private int LineOf(double latitudeDegrees) =>
        Math.Clamp((int)Math.Floor((90.0 - latitudeDegrees) * _pixelsPerDegree), 0, (180 * _pixelsPerDegree) - 1);
}
