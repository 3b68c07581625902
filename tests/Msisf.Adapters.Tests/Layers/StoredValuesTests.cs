using Msisf.Adapters.Layers;
using Msisf.Core.Layers;
using Xunit;

namespace Msisf.Adapters.Tests.Layers;

public class StoredValuesTests
{
    [Theory]
    [InlineData("aspect", 359.99999, 0.0f)] // nearer to 360 than to the next single below, 359.99997
    [InlineData("aspect", 359.99997, 359.99997f)]
    [InlineData("illumination-direction", 359.999999999, 0.0f)]
    [InlineData("depth", 359.99999, 360.0f)]
    [InlineData("depth", 16777217.0, 16777216.0f)] // 2^24 + 1
    public void Round_Value_IsTheNearestThatTheLayerMayHave(string layer, double value, float expected)
    {
        float[] stored = new float[2];

        StoredValues.Round(Assert.Single(LayerSet.Parse(layer).Layers), [value, double.NaN], stored);

        Assert.Equal([expected, float.NaN], stored);
    }
}
