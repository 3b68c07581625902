using Msisf.Core.Errors;
using Msisf.Core.Terrain;
using Msisf.TestSupport;

namespace Msisf.Core.Tests.Lod;

/// <summary>Counts the samples that are read of a model, and fails when it is told to.</summary>
internal sealed class CountingGrid(FunctionGrid grid) : IGlobalGrid
{
    private long _samplesRead;

    public long SamplesRead => Interlocked.Read(ref _samplesRead);

    public bool Fails { get; set; }

    public string ProductId => grid.ProductId;

    public int PixelsPerDegree => grid.PixelsPerDegree;

    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        if (Fails)
        {
            throw new BadInputException("damaged");
        }

        Interlocked.Add(ref _samplesRead, radii.Length);
        grid.ReadRadii(line, firstSample, radii);
    }
}
