using Msisf.Adapters.Illumination;
using Msisf.Core.Errors;
using Msisf.Core.Illumination;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Illumination;

public sealed class HorizonFileTests : IDisposable
{
    /// <summary>Two places: one with the first and the last column alone, one with a corner between them.</summary>
    private static readonly PlaceHorizons Two = new(
        [1_737_400.25, 1_738_000.0], [0.5f, -0.25f], [2, 5], [0x0000_1234, Last | 0x5678, 0x0000_0001, 0x0123_0002, Last | 3]);

    private const uint Last = (uint)(HorizonSurvey.Columns - 1) << 16;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Read_WhatWasWritten_IsTheSame()
    {
        HorizonFile.Write(_folder["a"], Two);

        PlaceHorizons read = HorizonFile.Read(_folder["a"], places: 2)!;

        Assert.Equal(Two.Radii, read.Radii);
        Assert.Equal(Two.Slopes, read.Slopes);
        Assert.Equal(Two.Ends, read.Ends);
        Assert.Equal(Two.Corners, read.Corners);
        Assert.Equal("MSISHOR1"u8, File.ReadAllBytes(_folder["a"]).AsSpan(0, 8));
    }

    [Fact]
    public void Read_NoFile_IsNothing() => Assert.Null(HorizonFile.Read(_folder["none"], places: 2));

    [Theory]
    [InlineData(3, 0, 0)] // other places than are asked for
    [InlineData(2, 0, 'x')] // another mark
    [InlineData(2, 16 + 16 + 8 + 4, 6)] // the second place ends behind the corners
    [InlineData(2, 16 + 16 + 8, 1)] // the first place has one corner
    public void Read_AnotherFile_IsRefused(int places, int at, int value)
    {
        HorizonFile.Write(_folder["a"], Two);
        byte[] bytes = File.ReadAllBytes(_folder["a"]);
        bytes[at] = value == 0 ? bytes[at] : (byte)value;
        File.WriteAllBytes(_folder["a"], bytes);

        BadInputException error = Assert.Throws<BadInputException>(() => HorizonFile.Read(_folder["a"], places));

        Assert.Equal($"{_folder["a"]}: no horizons of {places} places. Remove the file; it is made again.", error.Message);
    }

    [Theory]
    [InlineData(4)]
    [InlineData(40)]
    public void Read_CutOff_IsRefused(int length)
    {
        HorizonFile.Write(_folder["a"], Two);
        File.WriteAllBytes(_folder["a"], File.ReadAllBytes(_folder["a"])[..length]);

        Assert.StartsWith(_folder["a"], Assert.Throws<BadInputException>(() => HorizonFile.Read(_folder["a"], 2)).Message);
    }
}
