using System.Diagnostics;
using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Core.Tests.Numerics;

/// <summary>The build that the tests run refuses every access beyond an array, so each of them is a test of the kernels' ranges.</summary>
public sealed class ArrayLanesTests
{
    private const int Length = 21;

    [Theory]
    [InlineData(0, true)]
    [InlineData(Length - 16, true)]
    [InlineData(Length - 15, false)]
    [InlineData(-1, false)]
    [InlineData(int.MaxValue, false)]
    public void Load_SixteenNumbers_IsRefusedBeyondTheArray(int first, bool isIn)
    {
        float[] values = Numbers();
        float[] copy = new float[Length];
        Check(isIn, () => ArrayLanes.Load(values, first).StoreTo(copy, first), () => copy[first + 15] == first + 15);
        Check(isIn, () => ArrayLanes.Load(values.AsSpan(), first).StoreTo(copy.AsSpan(), first), () => copy[first] == first);
        Check(isIn, () => Vector512<float>.Zero.StoreTo(copy, first), () => copy[first + 15] == 0.0f);
        Check(isIn, () => Vector512<float>.One.StoreTo(copy.AsSpan(), first), () => copy[first + 15] == 1.0f);
    }

    [Theory]
    [InlineData(0, true)]
    [InlineData(Length - 8, true)]
    [InlineData(Length - 7, false)]
    [InlineData(-1, false)]
    public void Load256_EightNumbers_IsRefusedBeyondTheArray(int first, bool isIn)
    {
        float[] values = Numbers();
        float[] copy = new float[Length];
        Check(isIn, () => ArrayLanes.Load256(values, first).StoreTo(copy, first), () => copy[first + 7] == first + 7);
        Check(isIn, () => ArrayLanes.Load256(values.AsSpan(), first).StoreTo(copy.AsSpan(), first), () => copy[first] == first);
        Check(isIn, () => Vector256<float>.Zero.StoreTo(copy, first), () => copy[first + 7] == 0.0f);
        Check(isIn, () => Vector256<float>.One.StoreTo(copy.AsSpan(), first), () => copy[first + 7] == 1.0f);
    }

    [Theory]
    [InlineData(Length - 4, true)]
    [InlineData(Length - 3, false)]
    [InlineData(-1, false)]
    public void Load128_FourNumbers_IsRefusedBeyondTheArray(int first, bool isIn)
    {
        Vector128<float> loaded = default;
        Check(isIn, () => loaded = ArrayLanes.Load128(Numbers().AsSpan(), first), () => loaded[3] == first + 3);
    }

    [Theory]
    [InlineData(Length - 1, true)]
    [InlineData(Length, false)]
    [InlineData(-1, false)]
    public void At_OneElement_IsRefusedBeyondTheArray(int index, bool isIn)
    {
        float[] values = Numbers();
        Check(isIn, () => ArrayLanes.At(values, index) += 100.0f, () => values[index] == index + 100.0f);
    }

    private static float[] Numbers() => [.. Enumerable.Range(0, Length).Select(i => (float)i)];

    private static void Check(bool isIn, Action access, Func<bool> isDone)
    {
        bool isChecked = false;
        Debug.Assert(isChecked = true, "Only debug builds come here.");
        Assert.True(isChecked, "This is no debug build.");
        Exception? refusal = Record.Exception(access);
        Assert.Equal(isIn, refusal is null);
        Assert.True(!isIn || isDone());
    }
}
