using Msisf.Adapters.Raster.Heights;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

public class BilinearTests
{
    /// <summary>Four at a time and one at a time have the same bits: places on pixels, beside the map, near holes, in any order.</summary>
    [Theory]
    [InlineData(0.0)]
    [InlineData(0.3)]
    public void Blend_AnyLength_HasTheBitsOfTheFormula(double down)
    {
        Random random = new(41);
        float[] upper = [.. Enumerable.Range(0, 40).Select(i =>
            i == 17 ? float.NaN : i == 18 ? -0.0F : (float)(20_000 * random.NextDouble()))];
        float[] lower = [.. upper.Select(value => value - 7.25F)];
        for (int length = 1; length < 30; length++)
        {
            int[] left = [.. Enumerable.Range(0, length).Select(i => i % 5 == 4 ? random.Next(39) : i)];
            double[] across = [.. left.Select((_, i) => i % 7 == 3 ? 0.0 : i % 11 == 10 ? double.NaN : random.NextDouble())];
            int[] right = [.. left.Select((first, i) => across[i] > 0.0 ? first + 1 : first)];
            float[] values = new float[length];

            Bilinear.Blend(values, upper, lower, down, left, right, across);

            for (int i = 0; i < length; i++)
            {
                double above = Between(upper, left[i], across[i]);
                double expected = down == 0.0 ? above : above + (down * (Between(lower, left[i], across[i]) - above));
                Assert.Equal(BitConverter.SingleToInt32Bits((float)expected), BitConverter.SingleToInt32Bits(values[i]));
            }
        }

        static double Between(float[] row, int first, double part) =>
            part == 0.0 ? row[first] : row[first] + (part * ((double)row[first + 1] - row[first]));
    }
}
