using Msisf.Adapters.Raster.Albedo;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Albedo;

public sealed class HalvedMapSourceTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Read_Twice_IsTheMeanOverTheSphereOfFourPixels()
    {
        static double Value(int column, int row) => ((37 * column) + (91 * row)) % 250;
        string path = PdsMap.Write(_folder, "MAP", "PC_REAL", 32, 1, Value, north: 60.0, degrees: (90, 60));
        using HalvedMapSource halved = new(new PdsMapSource(PdsMapLabel.TryRead(path)!));
        Assert.Equal((45, 30), (halved.Width, halved.Height));

        // A map of real numbers is read twice.
        for (int time = 0; time < 2; time++)
        {
            for (int first = 0; first < 30; first += 10)
            {
                float[] values = new float[10 * 45];
                halved.Read(first, 10, values);
                for (int i = 0; i < values.Length; i++)
                {
                    (int column, int row) = (2 * (i % 45), 2 * (first + (i / 45)));
                    double upper = Math.Cos(double.DegreesToRadians(59.5 - row));
                    double lower = Math.Cos(double.DegreesToRadians(58.5 - row));
                    double mean = ((upper * (Value(column, row) + Value(column + 1, row)))
                        + (lower * (Value(column, row + 1) + Value(column + 1, row + 1)))) / (2.0 * (upper + lower));
                    Assert.Equal(mean, values[i], 1e-4);
                }
            }
        }
    }
}
