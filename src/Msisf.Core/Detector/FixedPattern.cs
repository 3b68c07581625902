using System.Runtime.Intrinsics;
using Msisf.Core.Detector.Noise;
using Msisf.Core.Parallel;

namespace Msisf.Core.Detector;

/// <summary>What differs from pixel to pixel and stays the same in all frames. Depends on the seed and the detector's size only.</summary>
internal sealed class FixedPattern
{
    private readonly DetectorSettings _settings;
    private readonly int _width;

    /// <summary>Computes the pattern.</summary>
    /// <param name="width">px.</param>
    /// <param name="height">px.</param>
    public FixedPattern(DetectorSettings settings, int width, int height, int threads)
    {
        _settings = settings;
        _width = width;
        Response = new float[width * height];
        DarkElectrons = new float[width * height];
        ColumnOffsets = new double[width];
        WorkerTeam.Run(threads, height, (_, row) => FillRow(row), CancellationToken.None);
        PutDefects();
        if (settings.Seed is ulong seed && settings.ColumnOffset > 0.0)
        {
            FillColumns(NoiseSource.OfDetector(seed));
        }
    }

    /// <summary>Response of each pixel to light, 1 on average.</summary>
    public float[] Response { get; }

    /// <summary>Mean number of dark electrons of each pixel in the exposure time.</summary>
    public float[] DarkElectrons { get; }

    /// <summary>DN added to each column.</summary>
    public double[] ColumnOffsets { get; }

    private double DarkMean => _settings.Dark.Rate * _settings.Dark.TemperatureFactor * _settings.ExposureTime;

    private void FillRow(int row)
    {
        for (int start = 0; start < _width; start += NoiseSource.MaxRun)
        {
            int index = (row * _width) + start;
            int count = Math.Min(NoiseSource.MaxRun, _width - start);
            FillRun((uint)index, Response.AsSpan(index, count), DarkElectrons.AsSpan(index, count));
        }
    }

    private void FillRun(uint first, Span<float> response, Span<float> dark)
    {
        response.Fill(1.0f);
        dark.Fill((float)DarkMean);
        if (_settings.Seed is not ulong seed)
        {
            return;
        }

        NoiseSource noise = NoiseSource.OfDetector(seed);
        Span<double> deviates = stackalloc double[response.Length];
        if (_settings.ResponseNonuniformity > 0.0)
        {
            NormalDeviate.Fill(noise, NoiseKind.Response, first, deviates);
            for (int i = 0; i < response.Length; i++)
            {
                response[i] = (float)Math.Max(0.0, 1.0 + (_settings.ResponseNonuniformity * deviates[i]));
            }
        }

        if (_settings.Dark.Nonuniformity > 0.0)
        {
            NormalDeviate.Fill(noise, NoiseKind.DarkCurrent, first, deviates);
            FillDark(deviates, dark);
        }

        PutRandomDefects(noise, first, response, dark);
    }

    /// <summary>Log-normal numbers: positive, with long tails, as dark currents are found to be.</summary>
    private void FillDark(ReadOnlySpan<double> deviates, Span<float> dark)
    {
        double variance = Math.Log(1.0 + (_settings.Dark.Nonuniformity * _settings.Dark.Nonuniformity));
        double sigma = Math.Sqrt(variance);
        Span<double> exponentials = stackalloc double[NoiseSource.Lanes];
        for (int start = 0; start < dark.Length; start += NoiseSource.Lanes)
        {
            int count = Math.Min(NoiseSource.Lanes, dark.Length - start);
            deviates.Slice(start, count).CopyTo(exponentials);
            PortableLanes.Exp((sigma * Vector512.Create<double>(exponentials)) - Vector512.Create(0.5 * variance))
                .CopyTo(exponentials);
            for (int lane = 0; lane < count; lane++)
            {
                dark[start + lane] = (float)(DarkMean * exponentials[lane]);
            }
        }
    }

    private void PutRandomDefects(in NoiseSource noise, uint first, Span<float> response, Span<float> dark)
    {
        if (_settings.Dark.HotFraction <= 0.0 && _settings.DeadFraction <= 0.0)
        {
            return;
        }

        for (int i = 0; i < response.Length; i++)
        {
            (double hot, double dead) = noise.Uniforms(NoiseKind.Defect, first + (uint)i);
            dark[i] = hot < _settings.Dark.HotFraction ? DarkOf(_settings.Dark.HotRate) : dark[i];
            response[i] = dead < _settings.DeadFraction ? 0.0f : response[i];
        }
    }

    private void PutDefects()
    {
        foreach (HotPixel hot in _settings.Dark.HotPixels)
        {
            DarkElectrons[((hot.Y - 1) * _width) + hot.X - 1] = DarkOf(hot.Rate);
        }

        foreach (DeadPixel dead in _settings.DeadPixels)
        {
            Response[((dead.Y - 1) * _width) + dead.X - 1] = 0.0f;
        }
    }

    private float DarkOf(double rate) => (float)(rate * _settings.Dark.TemperatureFactor * _settings.ExposureTime);

    private void FillColumns(in NoiseSource noise)
    {
        for (int start = 0; start < _width; start += NoiseSource.MaxRun)
        {
            Span<double> offsets = ColumnOffsets.AsSpan(start, Math.Min(NoiseSource.MaxRun, _width - start));
            NormalDeviate.Fill(noise, NoiseKind.ColumnOffset, (uint)start, offsets);
            foreach (ref double offset in offsets)
            {
                offset *= _settings.ColumnOffset;
            }
        }
    }
}
