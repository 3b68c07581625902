using Msisf.Stress.Reference;
using Xunit;

namespace Msisf.Stress.Tests.Reference;

public sealed class DoubleWordTests
{
    /// <summary>A root that hid it would make a length of 0 of a vector without meaning: no error at all.</summary>
    [Theory]
    [InlineData(double.NaN)]
    [InlineData(-1.0)]
    public void Sqrt_OfNoNumberOrANegativeOne_IsNoNumber(double value) => Assert.True(double.IsNaN(DoubleWord.Sqrt(value).High));

    [Fact]
    public void Sqrt_OfZero_IsZero() => Assert.Equal(default, DoubleWord.Sqrt(0.0));
}
