using System.IO.Compression;
using System.Text;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.Adapters.Tests.Ccsds;

public sealed class OemErrorTests
{
    private const string Begins = "orbit.oem, line ";

    [Theory]
    [InlineData("2060.0 1.0", "NaN 1.0", "18: 'NaN' is not finite; a finite number is needed.")]
    [InlineData("2060.0 1.0", "2060.0", "18: 5 numbers behind the time; 6 are needed (X Y Z X_DOT Y_DOT Z_DOT), or 9 with accelerations.")]
    [InlineData("12:01:00.000 ", "12:02:00.000 ", "19: the time of the line before occurs again, with other numbers. Remove")]
    [InlineData("12:01:00.000 ", "12:02:30.000 ", "19: the time is before that of the line above. Put the lines into the order of time.")]
    [InlineData("12:01:00.000 ", "12:61:00.000 ", "18: '2024-01-19T12:61:00.000' is not a time, which looks like 2024-01-19T12:00:00.000")]
    [InlineData("2024-01-19T12:01", "2024-02-30T12:01", "18: '2024-02-30T12:01:00.000' is not a time")]
    [InlineData("2024-01-19T12:01:00", "2024-01-19T23:59:60", "18: '2024-01-19T23:59:60.000': there was no leap second then.")]
    [InlineData("= MOON", "= MARS BARYCENTER", "9: CENTER_NAME = 'MARS BARYCENTER': MOON, LUNA and EARTH are read.")]
    [InlineData("EME2000", "ITRF-97", "10: REF_FRAME = 'ITRF-97': EME2000, J2000, ICRF, GCRF, MOON_ME and MOON_PA are read.")]
    [InlineData("= UTC", "= MET", "11: TIME_SYSTEM = 'MET': UTC, TAI, TT, TDB, GPS are read.")]
    [InlineData("= HERMITE", "= SPLINE", "14: INTERPOLATION = 'SPLINE': LINEAR, LAGRANGE and HERMITE are known.")]
    [InlineData("DEGREE = 7", "DEGREE = 0", "15: INTERPOLATION_DEGREE = '0': a whole number from 1 to 31 is needed.")]
    [InlineData("CENTER_NAME", "CENTRE_NAME", "9: there is no keyword 'CENTRE_NAME': did you mean CENTER_NAME?")]
    [InlineData("CENTER_NAME = MOON\n", "", "15: the block above has no CENTER_NAME: about which body its numbers are. Add it.")]
    [InlineData("TIME_SYSTEM = UTC\n", "", "15: the block above has no TIME_SYSTEM")]
    [InlineData("OBJECT_ID = 2024-001A", "CENTER_NAME = EARTH", "9: CENTER_NAME is in line 8 too, with another value.")]
    [InlineData("OEM_VERS = 2.0", "OEM_VERS = 4.0", "1: CCSDS_OEM_VERS = '4.0': versions 1.0, 2.0, 3.0 are read.")]
    [InlineData("CCSDS_OEM_VERS = 2.0", "CCSDS_AEM_VERS = 2.0", "1: this is not an OEM: it begins with 'CCSDS_AEM_VERS'")]
    [InlineData("CCSDS_OEM_VERS = 2.0\n", "", "2: 'CREATION_DATE' is above the version. The first line is CCSDS_OEM_VERS = 3.0.")]
    [InlineData("META_STOP", "META_STOPP", "16: 'META_STOPP' is neither 'keyword = value' nor a line of numbers.")]
    [InlineData("2024-01-19T12:02", "REF_FRAME = ICRF\n2024-01-19T12:02", "19: REF_FRAME is among the lines of numbers.")]
    [InlineData("META_START", "COVARIANCE_START", "6: COVARIANCE_START does not belong here.")]
    public void ReadOem_Wrong_SaysWhereAndWhat(string right, string wrong, string expected)
    {
        BadInputException failure = Assert.Throws<BadInputException>(
            () => CcsdsTexts.ReadOem(CcsdsTexts.Oem.Replace(right, wrong, StringComparison.Ordinal)));

        Assert.StartsWith(Begins + expected, failure.Message);
        Assert.DoesNotContain('\n', failure.Message);
    }

    [Fact]
    public void ReadOem_BlocksOfTwoSpacecraft_AreRefused()
    {
        string second = CcsdsTexts.Oem[CcsdsTexts.Oem.IndexOf("META_START", StringComparison.Ordinal)..]
            .Replace("ORBITER", "LANDER", StringComparison.Ordinal);

        BadInputException failure = Assert.Throws<BadInputException>(() => CcsdsTexts.ReadOem(CcsdsTexts.Oem + second));

        Assert.StartsWith($"{Begins}22: OBJECT_NAME = 'LANDER': the blocks above are of ORBITER.", failure.Message);
    }

    /// <summary>Two of one name are told apart by their IDs; an ID that nobody knows says nothing.</summary>
    [Fact]
    public void ReadOem_BlocksOfTwoIds_AreRefused()
    {
        string second = CcsdsTexts.Oem[CcsdsTexts.Oem.IndexOf("META_START", StringComparison.Ordinal)..]
            .Replace("2024-01-19T12", "2024-01-19T13", StringComparison.Ordinal);

        BadInputException failure = Assert.Throws<BadInputException>(
            () => CcsdsTexts.ReadOem(CcsdsTexts.Oem + second.Replace("2024-001A", "2024-001B", StringComparison.Ordinal)));

        Assert.StartsWith($"{Begins}23: OBJECT_ID = '2024-001B': the blocks above are of 2024-001A.", failure.Message);
        Assert.Equal(2, CcsdsTexts.ReadOem(CcsdsTexts.Oem + second.Replace("2024-001A", "NONE", StringComparison.Ordinal)).Count);
        Assert.Equal(2, CcsdsTexts.ReadOem(CcsdsTexts.Oem + second.Replace("2024-001A", "2024-001a", StringComparison.Ordinal)).Count);
    }

    [Fact]
    public void ReadAem_BlocksOfTwoIds_AreRefused()
    {
        string second = CcsdsTexts.Aem[CcsdsTexts.Aem.IndexOf("META_START", StringComparison.Ordinal)..]
            .Replace("2024-001A", "2024-001B", StringComparison.Ordinal);

        Assert.Contains(
            "OBJECT_ID = '2024-001B': the blocks above are of 2024-001A.",
            Assert.Throws<BadInputException>(() => CcsdsTexts.ReadAem(CcsdsTexts.Aem + second)).Message);
    }

    [Theory]
    [InlineData("", "orbit.oem, line 0: no block in the file.")]
    [InlineData("CCSDS_OEM_VERS = 2.0\n", "orbit.oem, line 1: no block in the file.")]
    [InlineData("CCSDS_OEM_VERS = 2.0\nMETA_START\nOBJECT_NAME = A\n", "orbit.oem, line 3: the file ends within the keywords of a block.")]
    [InlineData("just a text\n", "orbit.oem, line 1: 'just a text' is neither")]
    [InlineData("1 2 3\n", "orbit.oem, line 1: a line of numbers is above the first block.")]
    [InlineData("DAF/SPK \0\0", "orbit.oem, line 1, column 9: control character U+0000; this is not a text file.")]
    public void ReadOem_NoFileOfThisKind_SaysSo(string text, string expected) =>
        Assert.StartsWith(expected, Assert.Throws<BadInputException>(() => CcsdsTexts.ReadOem(text)).Message);

    [Fact]
    public void ReadOem_NoStates_IsNothingToRender()
    {
        string text = CcsdsTexts.Oem[..CcsdsTexts.Oem.IndexOf("2024-01-19T12:00:00.000 2000", StringComparison.Ordinal)];

        Assert.Equal(
            "orbit.oem: no block of it has a line of numbers.",
            Assert.Throws<NothingToRenderException>(() => CcsdsTexts.ReadOem(text)).Message);
    }

    [Theory]
    [InlineData(200)]
    [InlineData(11)]
    public void ReadOem_GzipCutOff_SaysSo(int length)
    {
        using MemoryStream packed = new();
        using (GZipStream gzip = new(packed, CompressionLevel.Fastest, leaveOpen: true))
        {
            gzip.Write(Encoding.UTF8.GetBytes(CcsdsTexts.Oem));
        }

        MsisfException failure = Assert.ThrowsAny<MsisfException>(() => CcsdsTexts.ReadOem(packed.ToArray()[..length]));

        Assert.StartsWith("orbit.oem, line ", failure.Message);
    }

    /// <summary>Any change of one byte is read, or refused with one line.</summary>
    [Fact]
    public void ReadOem_AnyByteChanged_NeverFailsOtherwise()
    {
        Random random = new(27);
        byte[] bytes = Encoding.UTF8.GetBytes(CcsdsTexts.Oem);
        for (int i = 0; i < TestSupport.TestLength.Of(2_000, 100_000); i++)
        {
            byte[] changed = [.. bytes];
            changed[random.Next(changed.Length)] = (byte)random.Next(256);
            Exception? failure = Record.Exception(() => CcsdsTexts.ReadOem(changed));
            Assert.True(failure is null or MsisfException, failure?.ToString());
        }
    }
}
