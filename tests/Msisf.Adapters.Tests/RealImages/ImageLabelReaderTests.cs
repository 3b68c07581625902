using System.Globalization;
using System.Runtime.InteropServices;
using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.RealImages;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.RealImages;

public sealed class ImageLabelReaderTests : IDisposable
{
    private const string Cube =
        "Object = IsisCube\n  Object = Core\n    StartByte = 1001\n    Format = BandSequential\n    Group = Dimensions\n      Samples = 3\n"
            + "      Lines = 2\n      Bands = 1\n    End_Group\n    Group = Pixels\n      Type = Real\n      ByteOrder = Lsb\n"
            + "      Base = 0.0\n      Multiplier = 1.0\n    End_Group\n  End_Object\nEnd_Object\nEnd\n";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    /// <summary>As ISIS 2 wrote them: its cubes begin with an SFDU label, as some PDS products do.</summary>
    [Theory]
    [InlineData("clementine.cub")]
    [InlineData("clementine.img")]
    public void Read_CubeOfIsis2_IsNamedAsWhatItIs(string name)
    {
        File.WriteAllText(
            _folder[name],
            "CCSD3ZF0000100000001NJPL3IF0PDS200000001 = SFDU_LABEL\r\nRECORD_TYPE = FIXED_LENGTH\r\n^QUBE = 5\r\nOBJECT = QUBE\r\n"
                + "  AXES = 3\r\n  CORE_ITEMS = (64,64,1)\r\nEND_OBJECT = QUBE\r\nEND\r\n");

        string image = Assert.Throws<BadInputException>(() => ImageLabelReader.Read(_folder[name])).Message;
        string model = Assert.Throws<BadInputException>(() => LdemLabelReader.ReadFile(_folder[name])).Message;

        Assert.Equal(
            $"{_folder[name]}: a cube of ISIS 2, which is not read. Give the PDS product that it was made from, or a cube of ISIS 3 or "
                + "later.",
            image);
        Assert.Equal(image, model);
    }

    /// <summary>Products of each kind, type, byte order and order of bands, written by numpy from the formats' own pages.</summary>
    [RequiresFact(Part.Numpy)]
    public void Read_ProductsOfNumpy_HaveTheirNumbers()
    {
        string script = Path.Combine(TestParts.RepositoryRoot, "tests", "Msisf.Adapters.Tests", "RealImages", "products.py");
        string[] lines = ChildRun.Of(TestParts.Python!, ["-B", script, _folder.Path], _folder.Path).Succeeded().Output.TrimEnd()
            .Split('\n');

        Assert.Equal(10, lines.Length);
        Assert.All(lines, line =>
        {
            string[] words = line.Split(' ');
            PixelLayout pixels = ImageLabelReader.Read(_folder[words[0]]).Pixels;
            (int bands, int height, int width) = pixels.Size;
            Assert.Equal($"{words[1]} {words[2]} {words[3]}", string.Create(CultureInfo.InvariantCulture, $"{bands} {height} {width}"));
            Assert.True(pixels.AreThere());
            float[] expected = MemoryMarshal.Cast<byte, float>(File.ReadAllBytes(_folder[words[4]])).ToArray();
            float[] found = [.. Enumerable.Range(0, pixels.Size.Bands).SelectMany(band => pixels.Read(band, 0, pixels.Size.Lines))];
            // floats have 6e-8; a factor of the label is taken in double here
            Assert.True(expected.Zip(found, (e, f) => e.Equals(f) || Math.Abs(e - f) <= 1e-6 * Math.Abs(e)).All(same => same), line);
            Assert.Equal(found[(2 * pixels.Size.Samples)..(4 * pixels.Size.Samples)], pixels.Read(0, 2, 2));
        });
    }

    [Fact]
    public void Read_KeywordsOfAllKinds_HaveOneName()
    {
        File.WriteAllText(_folder["a.cub"], Cube.Replace(
            "End_Object\nEnd\n",
            "  Group = Instrument\n    LineExposureDuration = 1.0288 <ms>\n    SpacecraftClockStartCount = Null\n"
                + "    Names = (a,\n b-\n  c)\n"
                + "  End_Group\nEnd_Object\nObject = NaifKeywords\n  INS-1_FOCAL_LENGTH = (6.5, 7)\nEnd_Object\nEnd\n",
            StringComparison.Ordinal));
        ImageLabel label = ImageLabelReader.Read(_folder["a.cub"]);

        Assert.Equal(0.0010288, label.Seconds(ImageLabel.NameOf("LRO:LINE_EXPOSURE_DURATION"))!.Value, Rounding.OfUnits);
        Assert.Null(label.Find("SPACECRAFTCLOCKSTARTCOUNT"));
        Assert.Equal(["a", "bc"], label.Find("NAMES")!.Items);
        Assert.Equal([6.5, 7.0], label.NaifNumbers("INS-1_FOCAL_LENGTH")!);
        Assert.False(label.Pixels.AreThere());
    }

    [Theory]
    [InlineData("", "as none of the labels that are known")]
    [InlineData("Object = IsisCube\nObject = Core\n", "the label ends")]
    [InlineData("PDS_VERSION_ID = PDS3\nEND\n", "the label has no object IMAGE")]
    [InlineData("<a/>", "no File_Area_Observational")]
    [InlineData("<a>\n<b>", "line 2: no XML")]
    [InlineData("<a><File_Area_Observational/></a>", "the label has no array")]
    [InlineData("Type = Real|Type = Complex", "Type = Complex; UnsignedByte, SignedWord, UnsignedWord or Real is needed")]
    [InlineData("Lines = 2|Lines = 0", "a whole number from 1 to")]
    [InlineData("Format = BandSequential|Format = Jpeg", "Tile or BandSequential is needed")]
    [InlineData("Group = Dimensions|Group = Size", "the cube's label has no Dimensions")]
    public void Read_WrongLabel_IsOneLineWithTheFile(string change, string expected)
    {
        string[] parts = change.Split('|');
        File.WriteAllText(_folder["a.lbl"], parts.Length == 2 ? Cube.Replace(parts[0], parts[1], StringComparison.Ordinal) : change);

        BadInputException exception = Assert.Throws<BadInputException>(() => ImageLabelReader.Read(_folder["a.lbl"]));

        Assert.Contains(expected, exception.Message, StringComparison.Ordinal);
        Assert.StartsWith(_folder["a.lbl"], exception.Message, StringComparison.Ordinal);
        Assert.DoesNotContain('\n', exception.Message);
    }

    /// <summary>
    /// Spellings of the interleaving, and synonyms of the types in the PDS Standards Reference 3.8, appendix C: two bands of 1 x 2 px
    /// whose bytes are 1 to 8.
    /// </summary>
    [Theory]
    [InlineData("BAND_SEQUENTIAL", "MSB_INTEGER", 0x0506)]
    [InlineData("\"BAND SEQUENTIAL\"", "MSB_INTEGER", 0x0506)]
    [InlineData("\"Band Sequential\"", "\"SUN INTEGER\"", 0x0506)]
    [InlineData("BSQ", "INTEGER", 0x0506)]
    [InlineData("\"LINE INTERLEAVED\"", "MAC_UNSIGNED_INTEGER", 0x0506)]
    [InlineData("\"SAMPLE-INTERLEAVED\"", "UNSIGNED_INTEGER", 0x0304)]
    [InlineData("BIP", "VAX_INTEGER", 0x0403)]
    [InlineData("\"BAND SEQUENTIAL\"", "\"PC UNSIGNED INTEGER\"", 0x0605)]
    [InlineData("\"BAND SEQUENTIAL\"", "LSB_INTEGER", 0x0605)]
    public void Read_SpellingsOfPds3_AreTheStandards(string order, string type, int secondBand)
    {
        string label = $"PDS_VERSION_ID = PDS3\n^IMAGE = \"a.img\"\nA = 1\nA = 2\nTARGET_NAME = MOON\nOBJECT = IMAGE\n"
                + $" LINES = 1\n LINE_SAMPLES = 2\n"
            + $" SAMPLE_TYPE = {type}\n SAMPLE_BITS = 16\n BANDS = 2\n BAND_STORAGE_TYPE = {order}\nEND_OBJECT = IMAGE\nEND\n";
        File.WriteAllText(_folder["a.lbl"], label);
        File.WriteAllBytes(_folder["a.img"], [1, 2, 3, 4, 5, 6, 7, 8]);

        ImageLabel read = ImageLabelReader.Read(_folder["a.lbl"]);

        Assert.Equal(secondBand, read.Pixels.Read(1, 0, 1)[0]);
        Assert.Equal("MOON", read.Text("TARGETNAME"));
        Assert.Contains("line 4: A = 2; line 3 of the same object says 1", Assert.Throws<BadInputException>(
            () => read.Text("A")).Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("VAX_REAL", 32)]
    [InlineData("COMPLEX", 64)]
    [InlineData("BIT_STRING", 8)]
    public void Read_TypesOfPds3WithoutCounterpart_AreRefused(string type, int bits)
    {
        File.WriteAllText(
            _folder["a.lbl"],
            $"PDS_VERSION_ID = PDS3\n^IMAGE = \"a.img\"\nOBJECT = IMAGE\n LINES = 1\n LINE_SAMPLES = 2\n SAMPLE_TYPE = {type}\n"
                + $" SAMPLE_BITS = {bits}\nEND_OBJECT = IMAGE\nEND\n");

        Assert.Contains($"SAMPLE_TYPE = {type}; integers of 8, 16 or 32 bits", Assert.Throws<BadInputException>(
            () => ImageLabelReader.Read(_folder["a.lbl"])).Message, StringComparison.Ordinal);
    }

    /// <summary>The kernels of a cube's group as options, for the message that asks for kernels.</summary>
    [Fact]
    public void Tables_WithoutThem_NameTheKernelsOfTheCube()
    {
        File.WriteAllText(_folder["a.cub"], Cube.Replace(
            "End_Object\nEnd\n", "  Group = Kernels\n    InstrumentPointing = (Table, $lro/ck/lrolc.bc, $lro/fk/lro_frames.tf)\n"
                + "    InstrumentPosition = $lro/spk/LRO_ES.bsp\n    ShapeModel = ldem.cub\n  End_Group\nEnd_Object\nEnd\n",
            StringComparison.Ordinal));
        CubeTables tables = ImageLabelReader.Read(_folder["a.cub"]).Tables!;

        Assert.EndsWith(
            "the cube lists --ck $lro/ck/lrolc.bc --kernels $lro/fk/lro_frames.tf --spk $lro/spk/LRO_ES.bsp.",
            Assert.Throws<BadInputException>(() => new CubeStates(tables, "a.cub")).Message, StringComparison.Ordinal);
    }

    /// <summary>Of 24 bytes from byte 1001 on.</summary>
    [Theory]
    [InlineData(1000, false)]
    [InlineData(1001, null)]
    [InlineData(1023, null)]
    [InlineData(1024, true)]
    public void AreThere_CutOffAnywhere_IsAnError(int bytes, bool? areThere)
    {
        File.WriteAllBytes(_folder["a.cub"], [.. System.Text.Encoding.ASCII.GetBytes(Cube), .. new byte[bytes - Cube.Length]]);
        PixelLayout pixels = ImageLabelReader.Read(_folder["a.cub"]).Pixels;

        if (areThere is { } expected)
        {
            Assert.Equal(expected, pixels.AreThere());
            return;
        }

        Assert.Contains(
            $"{bytes} bytes, and its label says 1024: the pixels are cut off",
            Assert.Throws<BadInputException>(() => pixels.AreThere()).Message, StringComparison.Ordinal);
    }
}
