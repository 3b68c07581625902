using System.Text;
using Msisf.Adapters.Metadata;
using Xunit;

namespace Msisf.Adapters.Tests.Metadata;

public class LongETests
{
    // Python: print('%+.15e' % x), the exponent padded to 3 digits.
    [Theory]
    [InlineData(2e6, "+2.000000000000000E+006")]
    [InlineData(-1.04243073487898e11, "-1.042430734878980E+011")]
    [InlineData(-2.391176183943345e-001, "-2.391176183943345E-001")]
    [InlineData(44.58440049692386, "+4.458440049692386E+001")]
    [InlineData(0.1, "+1.000000000000000E-001")]
    [InlineData(1.0 / 3.0, "+3.333333333333333E-001")]
    [InlineData(999999999999999.9, "+9.999999999999999E+014")]
    [InlineData(9.9999999999999995e22, "+9.999999999999999E+022")]
    [InlineData(5e-324, "+4.940656458412465E-324")]
    [InlineData(double.MaxValue, "+1.797693134862316E+308")]
    [InlineData(0.0, "+0.000000000000000E+000")]
    public void ToText_Number_Has16DigitsAndBothSigns(double value, string expected) =>
        Assert.Equal(expected, LongE.ToText(value));

    [Fact]
    public void ToText_MinusZero_HasAPlus() => Assert.Equal("+0.000000000000000E+000", LongE.ToText(-0.0));

    [Fact]
    public void Write_LongerSpan_FillsTheFirst23Bytes()
    {
        byte[] bytes = new byte[LongE.Length + 1];

        Assert.Equal(LongE.Length, LongE.Write(-1e-5, bytes));

        Assert.Equal("-1.000000000000000E-005\0", Encoding.ASCII.GetString(bytes));
    }

    // Python: repr(x). 16 digits read back to a neighbour.
    [Theory]
    [InlineData(0.1 + 0.2, "0.30000000000000004")]
    [InlineData(-1837400.0000000002, "-1837400.0000000002")]
    [InlineData(-2.2250738585072014E-308, "-2.2250738585072014E-308")]
    [InlineData(-0.0, "0")]
    public void ToText_RoundTrip_ReadsBackToTheSameDouble(double value, string expected)
    {
        string text = LongE.ToText(value, LongEDigits.RoundTrip);

        Assert.Equal(expected, text);
        Assert.Equal(value, double.Parse(text, System.Globalization.CultureInfo.InvariantCulture));
        Assert.InRange(text.Length, 1, LongE.MaximumLength);
        Assert.True(value == 0.0 || value != double.Parse(LongE.ToText(value), System.Globalization.CultureInfo.InvariantCulture));
    }

    [Theory]
    [InlineData(double.NaN)]
    [InlineData(double.NegativeInfinity)]
    public void ToText_NotFinite_IsABug(double value) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => LongE.ToText(value));

    [Fact]
    public void Write_TooLittleRoom_IsABug() =>
        Assert.Throws<ArgumentOutOfRangeException>(() => LongE.Write(1.0, new byte[LongE.Length - 1]));
}
