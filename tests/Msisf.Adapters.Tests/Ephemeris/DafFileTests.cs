using System.Text;
using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.Adapters.Tests.Ephemeris;

public class DafFileTests
{
    private const int FirstSummary = 1024 + 24;

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Open_EitherByteOrder_GivesSummariesAndData(bool bigEndian)
    {
        byte[] bytes = new DafBuilder("DAF/SPK", bigEndian).AddRaw(
            -5.0, 7.0, [10, 0, 1, 2], [1.5, -2.5]).AddRaw(0.0, 1.0, [301, 3, 1, 2], [8.0]).ToArray();
        using DafFile file = Open(bytes);
        double[] data = new double[2];

        file.ReadDoubles(file.Summaries[0].FirstAddress, data);

        Assert.Equal([1.5, -2.5], data);
        Assert.Equal(new TdbInterval(-5.0, 7.0), file.Summaries[0].Interval);
        Assert.Equal([301, 3, 1, 2, 387, 387], file.Summaries[1].Integers);
        Assert.Equal("DAF/SPK", file.IdWord);
    }

    [Fact]
    public void Open_TooShort_SaysHowLong() => AssertFails(new byte[100], "100 bytes are too few");

    [Fact]
    public void Open_OtherIdWord_NamesIt() =>
        AssertFails(Change(bytes => Encoding.ASCII.GetBytes("DAF/XY  ").CopyTo(bytes, 0)), "begins with \"DAF/XY\"");

    [Fact]
    public void Open_OtherNumberFormat_NamesIt() =>
        AssertFails(Change(bytes => Encoding.ASCII.GetBytes("VAX-GFLT").CopyTo(bytes, 88)), "VAX-GFLT");

    [Fact]
    public void Open_OtherByteOrderThanItSays_IsDamaged() => AssertFails(
        Change(bytes => Encoding.ASCII.GetBytes("BIG-IEEE").CopyTo(bytes, 88)), "summaries of 33554432 doubles and 100663296 integers");

    /// <summary>NAIF, DAF Required Reading, "FTP validation string"; without one (older kernels) nothing can be told.</summary>
    [Fact]
    public void Open_TransferredAsText_SaysSo()
    {
        byte[] mark = [.. "FTPSTR:\r:\n:\r\n:\r\0:"u8, 0x81, .. ":"u8, 0x10, 0xCE, .. ":ENDFTP"u8];
        using (DafFile whole = Open(Change(bytes => mark.CopyTo(bytes, 699))))
        {
            Assert.NotEmpty(whole.Summaries);
        }

        AssertFails(
            Change(bytes => mark.Where(value => value != '\r').ToArray().CopyTo(bytes, 699)), "it was transferred as text");
    }

    [Fact]
    public void Open_OtherSummaryFormat_IsDamaged() => AssertFails(Change(bytes => bytes[12] = 9), "2 doubles and 9 integers");

    [Fact]
    public void Open_DataCutOff_SaysFoundAndNeededBytes()
    {
        byte[] bytes = Sample();
        AssertFails(bytes[..^1], $"it has {bytes.Length - 1} bytes, but its data need {bytes.Length}");
    }

    [Fact]
    public void Open_SummaryRecordCutOff_IsDamaged() => AssertFails(Sample()[..1500], "out of the file or in a ring");

    [Fact]
    public void Open_SummaryRecordNamesItself_IsDamagedAndEnds() =>
        AssertFails(Change(bytes => BitConverter.GetBytes(2.0).CopyTo(bytes, 1024)), "out of the file or in a ring");

    [Theory]
    [InlineData(-1.0)]
    [InlineData(1e9)]
    [InlineData(double.NaN)]
    public void Open_NextSummaryRecordImpossible_IsDamaged(double next) =>
        AssertFails(Change(bytes => BitConverter.GetBytes(next).CopyTo(bytes, 1024)), "out of the file or in a ring");

    [Theory]
    [InlineData(-1.0)]
    [InlineData(26.0)]
    [InlineData(double.NaN)]
    public void Open_SegmentCountImpossible_IsDamaged(double count) =>
        AssertFails(Change(bytes => BitConverter.GetBytes(count).CopyTo(bytes, 1024 + 16)), "impossible number of segments");

    [Theory]
    [InlineData(0)]
    [InlineData(-9)]
    public void Open_FirstAddressImpossible_IsDamaged(int address) =>
        AssertFails(Change(bytes => BitConverter.GetBytes(address).CopyTo(bytes, FirstSummary + 32)), "impossible addresses");

    [Theory]
    [InlineData(double.NaN)]
    [InlineData(1e12)]
    public void Open_SegmentTimesDoNotRise_IsDamaged(double start) =>
        AssertFails(Change(bytes => BitConverter.GetBytes(start).CopyTo(bytes, FirstSummary)), "times do not rise");

    private static byte[] Sample() => new DafBuilder("DAF/SPK").AddRaw(-5.0, 7.0, [10, 0, 1, 2], [1.5, -2.5]).ToArray();

    private static byte[] Change(Action<byte[]> change)
    {
        byte[] bytes = Sample();
        change(bytes);
        return bytes;
    }

    private static DafFile Open(byte[] bytes) => new(new MemoryStream(bytes), "sample.bsp");

    private static void AssertFails(byte[] bytes, string expected)
    {
        BadInputException failure = Assert.Throws<BadInputException>(() => Open(bytes));

        Assert.StartsWith("sample.bsp: ", failure.Message, StringComparison.Ordinal);
        Assert.Contains(expected, failure.Message, StringComparison.Ordinal);
    }
}
