using System.Buffers.Binary;
using System.Runtime.InteropServices;
using System.Text.RegularExpressions;
using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Synthesis;
using Msisf.Adapters.Tests.Raster.Heights;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Synthesis;

public sealed partial class SyntheticLdemWriterTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("msisf-synthetic-").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Write_AnyNumberOfThreads_GivesTheSameBytes()
    {
        byte[] one = Image(Options(4, "one") with { Threads = 1 });
        byte[] four = Image(Options(4, "four") with { Threads = 4 });
        Assert.Equal(720 * 1440 * 2, one.Length);
        Assert.Equal(one, four);
    }

    [Theory]
    [InlineData(null, "45:46:359:360")]
    [InlineData(null, "-90:-88:0:3")]
    [InlineData(2, "89:90:77:80")]
    public void Write_Region_HasTheSamplesOfTheWholeMoon(int? baseResolution, string text)
    {
        const int Resolution = 4;
        MoonRegion region = MoonRegion.Parse(text);
        SyntheticLdemOptions options = Options(Resolution, "whole") with
        {
            Base = baseResolution is { } resolution ? FunctionGrid.Hilly(resolution) : null,
        };
        byte[] whole = Image(options);
        byte[] part = Image(options with { Region = region, Rest = SyntheticRest.None });
        int lineBytes = 2 * Resolution * (region.EastDegrees - region.WestDegrees);
        Assert.Equal(lineBytes * Resolution * (region.NorthDegrees - region.SouthDegrees), part.Length);
        for (int line = 0; line < part.Length / lineBytes; line++)
        {
            int wholeOffset = 2 * Resolution * ((((90 - region.NorthDegrees) * Resolution) + line) * 360 + region.WestDegrees);
            Assert.Equal(whole.AsSpan(wholeOffset, lineBytes), part.AsSpan(line * lineBytes, lineBytes));
        }
    }

    [Fact]
    public void Write_Label_StatesTheTrueExtremesAndTheSizes()
    {
        string label = SyntheticLdemWriter.Write(
            Options(64, "label") with
            {
                Region = new MoonRegion(0, 2, 350, 353),
                Rest = SyntheticRest.None,
                Format = SyntheticSampleFormat.Integers,
            },
            null,
            CancellationToken.None);
        string text = File.ReadAllText(label);
        byte[] image = File.ReadAllBytes(Path.ChangeExtension(label, ".IMG"));
        short[] samples = [.. Enumerable.Range(0, image.Length / 2).Select(
            i => BinaryPrimitives.ReadInt16LittleEndian(image.AsSpan(2 * i)))];
        Assert.Equal("LDEM_64_SYNTHETIC_00N_02N_350_353.LBL", Path.GetFileName(label));
        Assert.Equal($"{samples.Max()}", Value(text, "MAXIMUM"));
        Assert.Equal($"{samples.Min()}", Value(text, "MINIMUM"));
        Assert.Equal("128", Value(text, "LINES"));
        Assert.Equal("192", Value(text, "LINE_SAMPLES"));
        Assert.Equal("384", Value(text, "RECORD_BYTES"));
        Assert.Equal("2 <deg>", Value(text, "MAXIMUM_LATITUDE"));
        Assert.Equal("350 <deg>", Value(text, "WESTERNMOST_LONGITUDE"));
        Assert.Equal("127.5 <pix>", Value(text, "LINE_PROJECTION_OFFSET"));
        Assert.Equal("-10880.5 <pix>", Value(text, "SAMPLE_PROJECTION_OFFSET"));
        Assert.Equal("473.80 <m/pix>", Value(text, "MAP_SCALE"));
        Assert.All(text.Split('\n'), line => Assert.InRange(line.Length, 0, 80));
    }

    /// <summary>A region over the prime meridian: inside the samples of the whole, far outside those of the base.</summary>
    [Fact]
    public void Write_RestFromTheBase_HasDetailInTheRegionAndTheMeansOfTheBaseAround()
    {
        const int Resolution = 8;
        const int Samples = 360 * Resolution;
        FunctionGrid baseModel = FunctionGrid.Hilly(2);
        SyntheticLdemOptions options = Options(Resolution, "whole") with { Base = baseModel, Format = SyntheticSampleFormat.Floats };
        float[] whole = Floats(Image(options));
        float[] filled = Floats(Image(options with { Region = MoonRegion.Parse("-10:10:350:10") }));

        Assert.Equal(whole.Length, filled.Length);
        for (int line = 80 * Resolution; line < 100 * Resolution; line++)
        {
            Assert.Equal(whole.AsSpan(line * Samples, 10 * Resolution), filled.AsSpan(line * Samples, 10 * Resolution));
            Assert.Equal(
                whole.AsSpan((line * Samples) + (350 * Resolution), 10 * Resolution),
                filled.AsSpan((line * Samples) + (350 * Resolution), 10 * Resolution));
        }

        // A pixel of the base on the equator, at 180 degrees: its mean is kept, and there is no detail in it.
        double[] radius = new double[1];
        baseModel.ReadRadii(180, 360, radius);
        double[] pixel = [.. Enumerable.Range(0, 4).SelectMany(
            line => filled[(((720 + line) * Samples) + 1440)..(((720 + line) * Samples) + 1444)]).Select(value => 1000.0 * value)];
        Assert.Equal(radius[0] - MoonConstants.ReferenceRadius, pixel.Average(), 0.01);
        Assert.NotEqual(whole[(720 * Samples) + 1440], filled[(720 * Samples) + 1440]);
    }

    [Fact]
    public void Write_RestFromTheBase_HasNoStepAtTheRegionsBorder()
    {
        const int Resolution = 8;
        const int Samples = 360 * Resolution;
        SyntheticLdemOptions options = Options(Resolution, "whole") with
        {
            Base = FunctionGrid.Hilly(2),
            Format = SyntheticSampleFormat.Floats,
        };
        float[] whole = Floats(Image(options));
        float[] filled = Floats(Image(options with { Region = new MoonRegion(0, 10, 20, 60) }));

        // Largest differences of neighbouring lines: across the border they are as between lines of the whole.
        double Largest(float[] heights, int line) => Enumerable.Range(22 * Resolution, 36 * Resolution).Max(
            sample => Math.Abs(heights[((line + 1) * Samples) + sample] - heights[(line * Samples) + sample]));
        double typical = Enumerable.Range(85 * Resolution, 4 * Resolution).Max(line => Largest(whole, line));
        Assert.InRange(Largest(filled, (90 * Resolution) - 1), 0.0, 1.5 * typical); // one pair of lines against the largest of many
    }

    [Fact]
    public void Write_FlatRest_IsZeroAroundTheRegionAndDrawable()
    {
        SyntheticLdemOptions options = Options(64, "flat") with { Region = MoonRegion.Parse("0:1:359:1"), Rest = SyntheticRest.Flat };
        string label = SyntheticLdemWriter.Write(options, null, CancellationToken.None);
        using LdemImage image = LdemImage.Open(LdemCatalog.Read(label));

        Assert.Equal("LDEM_64_SYNTHETIC_00N_01N_359_001", image.ProductId);
        double[] radii = new double[180];
        image.ReadRadii(89 * 64, (358 * 64) + 4, radii);
        Assert.Equal(60, radii.TakeWhile(radius => radius == MoonConstants.ReferenceRadius).Count());
        image.ReadRadii(91 * 64, 0, radii);
        Assert.All(radii, radius => Assert.Equal(MoonConstants.ReferenceRadius, radius));
    }

    [Fact]
    public void Write_PartOverThePrimeMeridian_IsUsageError() =>
        Assert.Contains(
            "--rest none",
            Assert.Throws<UsageException>(() => SyntheticLdemWriter.Write(
                Options(4, ".") with { Region = MoonRegion.Parse("0:1:359:1"), Rest = SyntheticRest.None },
                null,
                CancellationToken.None)).Message,
            StringComparison.Ordinal);

    /// <summary>The keywords that NASA's float products have; the same heights as of integers, but for their steps of 0.5 m.</summary>
    [Fact]
    public void Write_Floats_ReadBackWithoutSteps()
    {
        string integers = SyntheticLdemWriter.Write(Options(4, "integers"), null, CancellationToken.None);
        string floats = SyntheticLdemWriter.Write(
            Options(4, "floats") with { Format = SyntheticSampleFormat.Floats }, null, CancellationToken.None);
        string text = File.ReadAllText(floats);
        Assert.Equal("PC_REAL", Value(text, "SAMPLE_TYPE"));
        Assert.Equal("32", Value(text, "SAMPLE_BITS"));
        Assert.Equal("KILOMETER", Value(text, "UNIT"));
        Assert.Equal("1", Value(text, "SCALING_FACTOR"));
        Assert.Equal("1737.4", Value(text, "OFFSET"));
        Assert.All(text.Split('\n'), line => Assert.InRange(line.Length, 0, 80));

        using LdemImage stepped = LdemImage.Open(LdemCatalog.Read(integers));
        using LdemImage smooth = LdemImage.Open(LdemCatalog.Read(floats));
        double[] expected = new double[1440];
        double[] found = new double[1440];
        stepped.ReadRadii(200, 0, expected);
        smooth.ReadRadii(200, 0, found);
        Assert.All(expected.Zip(found), pair => Assert.InRange(Math.Abs(pair.First - pair.Second), 0.0, 0.2501));
        Assert.Contains(found, radius => Math.Abs((2.0 * radius) - Math.Round(2.0 * radius)) > 0.2);
    }

    [Theory]
    [InlineData(63, true)]
    [InlineData(64, false)]
    public void DefaultFormat_FineModels_AreFloats(int pixelsPerDegree, bool isInteger) =>
        Assert.Equal(isInteger, SyntheticLdemOptions.DefaultFormat(pixelsPerDegree).IsInteger);

    [RequiresFact(Part.Ldem4)]
    public void Write_Label_HasTheKeywordsOfTheArchivesInTheirOrder()
    {
        string label = SyntheticLdemWriter.Write(Options(4, "keywords"), null, CancellationToken.None);
        string text = File.ReadAllText(label);
        string archive = File.ReadAllText(TestParts.Ldem4Label!);
        Assert.Equal(Keywords(archive), Keywords(text));
        string[] same =
        [
            "LINES", "LINE_SAMPLES", "RECORD_BYTES", "FILE_RECORDS", "SAMPLE_TYPE", "SAMPLE_BITS", "SCALING_FACTOR", "OFFSET",
            "MAP_RESOLUTION", "MAP_SCALE", "LINE_PROJECTION_OFFSET", "SAMPLE_PROJECTION_OFFSET", "LINE_LAST_PIXEL", "SAMPLE_LAST_PIXEL",
        ];
        foreach (string keyword in same)
        {
            Assert.Equal(Value(archive, keyword), Value(text, keyword));
        }

        foreach (string keyword in new[] { "DATA_SET_ID", "PRODUCT_ID" })
        {
            Assert.Contains("SYNTHETIC", Value(text, keyword), StringComparison.Ordinal);
        }

        Assert.Contains("THIS IS SYNTHETIC DATA", text, StringComparison.Ordinal);
        Assert.DoesNotContain("GODDARD", text, StringComparison.Ordinal);
    }

    private static float[] Floats(byte[] image) => MemoryMarshal.Cast<byte, float>(image).ToArray();

    internal static byte[] Image(SyntheticLdemOptions options) =>
        File.ReadAllBytes(Path.ChangeExtension(SyntheticLdemWriter.Write(options, null, CancellationToken.None), ".IMG"));

    private static string Value(string label, string keyword) =>
        Regex.Match(label, $@"^\s*{keyword}\s*=\s*(.*?)\s*$", RegexOptions.Multiline).Groups[1].Value;

    private static string[] Keywords(string label) => [.. KeywordPattern().Matches(label).Select(match => match.Groups[1].Value)];

    [GeneratedRegex(@"^\s*([\^A-Z_]+)\s*=", RegexOptions.Multiline)]
    private static partial Regex KeywordPattern();

    private SyntheticLdemOptions Options(int pixelsPerDegree, string subfolder) =>
        new(pixelsPerDegree, Seed: 1, Path.Combine(_folder, subfolder));
}
