using Msisf.Core.Errors;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Xunit;

namespace Msisf.Core.Tests.Render.Options;

public sealed class NativeRenderOptionsTests
{
    private static readonly NativeRenderOptions Plain = new() { Reflectance = new LambertReflectance(0.1) };

    [Theory]
    [InlineData(0)]
    [InlineData(17)]
    public void SubsamplesPerAxis_NoneOrMoreThanSixteen_IsRefused(int subsamples) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => Plain with { SubsamplesPerAxis = subsamples });

    [Fact]
    public void DetailSubsamplesPerAxis_IsThatOfTheSamples_AndFourWhereTheyAreAdaptive()
    {
        Assert.Equal(3, (Plain with { SubsamplesPerAxis = 3 }).DetailSubsamplesPerAxis);
        Assert.Equal(4, (Plain with { Adaptive = new AdaptiveSampling(0.4, new GreyScale()) }).DetailSubsamplesPerAxis);
    }

    [Theory]
    [InlineData(0.049)]
    [InlineData(50.1)]
    [InlineData(double.NaN)]
    public void AdaptiveSampling_ErrorOutOfRange_IsRefused(double error) =>
        Assert.Throws<BadInputException>(() => new AdaptiveSampling(error, new GreyScale()));
}
