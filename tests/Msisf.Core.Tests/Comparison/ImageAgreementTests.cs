using Msisf.Core.Comparison;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Comparison;

public sealed class ImageAgreementTests
{
    // python3 -c "import numpy as np; r=np.array([3,5,4,9.]); d=np.array([1,2,2,4.]); f=(r*d).sum()/(d*d).sum(); print(f,
    // np.corrcoef(r,d)[0,1], np.sqrt(np.mean((r-f*d)**2))/r.mean())"
    [Fact]
    public void Of_PixelsThatBothHave_IsNumpys()
    {
        float[] real = [3.0f, float.NaN, 5.0f, 4.0f, 7.0f, 9.0f];
        float[] drawn = [1.0f, 8.0f, 2.0f, 2.0f, float.NaN, 4.0f];

        ImageAgreement found = ImageAgreement.Of(real, drawn)!;

        Assert.Equal(4, found.Count);
        Assert.Equal(2.28, found.Factor, Rounding.OfChains);
        Assert.Equal(0.9820842820734642, found.Correlation!.Value, Rounding.OfChains);
        Assert.Equal(0.09712418121129114, found.Rms!.Value, Rounding.OfChains);
    }

    [Fact]
    public void Of_ChosenPixels_CountsThemOnly() =>
        Assert.Equal(2, ImageAgreement.Of([1.0f, 2.0f, 3.0f], [1.0f, 2.0f, 3.0f], i => i > 0)!.Count);

    [Theory]
    [InlineData(1.0f, float.NaN, 1.0f, 1.0f)]
    [InlineData(1.0f, 2.0f, 0.0f, 0.0f)]
    public void Of_NothingToCompare_IsNull(float r0, float r1, float d0, float d1) =>
        Assert.Null(ImageAgreement.Of([r0, r1], [d0, d1]));

    [Fact]
    public void Of_OneGrey_HasNoCorrelation()
    {
        ImageAgreement found = ImageAgreement.Of([2.0f, 2.0f], [1.0f, 3.0f])!;

        Assert.Null(found.Correlation);
        Assert.Equal(0.8, found.Factor, Rounding.OfChains); // (2 + 6) / (1 + 9)
        Assert.Equal(Math.Sqrt((1.44 + 0.16) / 2.0) / 2.0, found.Rms!.Value, Rounding.OfChains);
    }

    /// <summary>Zeros, and values whose mean is 0: what is a part of the mean has no value.</summary>
    [Theory]
    [InlineData(0.0f, 0.0f, false)]
    [InlineData(-1.0f, 1.0f, true)]
    public void Of_MeanOfZero_HasNoRelativeRms(float r0, float r1, bool hasCorrelation)
    {
        ImageAgreement found = ImageAgreement.Of([r0, r1], [1.0f, 3.0f])!;

        Assert.Null(found.Rms);
        Assert.Equal(hasCorrelation, found.Correlation is not null);
        Assert.Equal(1.0, found.Correlation ?? 1.0, Rounding.OfChains);
    }
}
