using Msisf.Core.Illumination;
using Xunit;

namespace Msisf.Core.Tests.Illumination;

public sealed class StepRunsTests
{
    [Theory]
    [InlineData("0", 0, 1, 0, 0, 0)]
    [InlineData("1", 0, 0, 0, 1, 0)]
    [InlineData("1100010111", 2, 3, 7, 3, 1)]
    [InlineData("00110000110000", 4, 4, 2, 2, 2)]
    [InlineData("0000000000000000000000000000000000000001", 0, 39, 39, 1, 1)]
    [InlineData("1111111111111111111111111111111111111111", 0, 0, 0, 40, 0)]
    public void Add_Steps_FindsTheLongestRunsAndLongNights(string steps, int dark, int darkCount, int light, int lightCount, int nights)
    {
        StepRuns runs = new(nightLimit: 2.0);
        for (int first = 0; first < steps.Length; first += 16)
        {
            string part = steps[first..Math.Min(steps.Length, first + 16)];
            runs.Add((uint)part.Select((step, at) => step == '1' ? 1 << at : 0).Sum(), part.Length);
        }

        runs.End();
        Assert.Equal((darkCount == 0 ? 0 : dark, darkCount), (darkCount == 0 ? 0 : runs.Dark.First, runs.Dark.Count));
        Assert.Equal((light, lightCount), (runs.Light.First, runs.Light.Count));
        Assert.Equal(nights, runs.Nights);
    }
}
