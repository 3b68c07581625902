using System.Security.Cryptography;
using Msisf.Adapters.Raster.Heights;
using Msisf.Core.Metadata;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Raster.Heights;

public sealed class LdemChecksumsTests : IDisposable
{
    /// <summary>Bytes: so long a file's checksum is remembered.</summary>
    private const int LargeImage = 5 << 20;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Read_LabelAndImage_HaveTheirBytesAndHashes()
    {
        string label = TestModel.Write(_folder.Path, TestModel.Label, "abc"u8.ToArray());

        (IReadOnlyList<InputFile> files, string? warning) = Read(label, null);

        // SHA-256 of "abc": FIPS 180-4, example of NIST.
        Assert.Equal(
            new InputFile(
                InputKind.ElevationImage, "LDEM_1.IMG", 3, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"),
            files[1]);
        Assert.Equal(
            (InputKind.ElevationLabel, Path.GetFileName(label), new FileInfo(label).Length),
            (files[0].Kind, files[0].Name, files[0].Bytes));
        Assert.Equal(Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(label))), files[0].Sha256);
        Assert.Equal((2, null), (files.Count, warning));
        Assert.False(File.Exists(Remembered(label)));
    }

    [Fact]
    public void Read_ModelTooLargeToBeRead_HasItsLabelsHashAndPiecesOfItsImage()
    {
        string label = TestModel.Write(_folder.Path, TestModel.Label, "abc"u8.ToArray());
        LdemChecksums checksums = LdemChecksums.Open(LdemSet.Join([LdemLabelReader.ReadFile(label)]), null, largestRead: 2);
        long bytesToRead = checksums.BytesToRead;

        IReadOnlyList<InputFile> files = checksums.Read(CancellationToken.None).Files;

        // python3: hashlib.sha256(struct.pack("<q", 3) + 64 * b"abc").hexdigest()
        Assert.Equal(
            new InputFile(
                InputKind.ElevationImage, "LDEM_1.IMG", 3, "1bd28ebf0e69fdd449a37fee00d52d6b6e935f0dec8760cb0950be3ac2a34d4c")
            {
                IsOfPieces = true,
            },
            files[1]);
        Assert.Equal(Read(label, null).Files[0], files[0]);
        Assert.Equal(new FileInfo(label).Length, bytesToRead);
    }

    [Fact]
    public void Read_LargeImageAgain_TakesWhatIsRemembered()
    {
        string label = Large();
        InputFile first = Read(label, null).Files[1];
        string wrong = new('a', 64);
        File.WriteAllText(Remembered(label), File.ReadAllText(Remembered(label)).Replace(first.Sha256, wrong, StringComparison.Ordinal));

        Assert.Equal(new FileInfo(label).Length, Open(label, null).BytesToRead);
        Assert.Equal(wrong, Read(label, null).Files[1].Sha256); // so the image was not read
    }

    [Theory]
    [InlineData("touched")]
    [InlineData("longer")]
    [InlineData("no digits")]
    [InlineData("another file")]
    public void Read_WhatIsRememberedDoesNotFit_ComputesItAnew(string change)
    {
        string label = Large();
        string image = _folder["LDEM_1.IMG"];
        string right = Read(label, null).Files[1].Sha256;
        string remembered = File.ReadAllText(Remembered(label));
        File.WriteAllText(Remembered(label), remembered.Replace(right, new string('a', 64), StringComparison.Ordinal));
        switch (change)
        {
            case "touched":
                File.SetLastWriteTimeUtc(image, File.GetLastWriteTimeUtc(image).AddSeconds(1));
                break;
            case "longer":
                DateTime written = File.GetLastWriteTimeUtc(image);
                File.AppendAllText(image, "x");
                File.SetLastWriteTimeUtc(image, written);
                break;
            case "no digits":
                File.WriteAllText(Remembered(label), remembered.Replace(right, new string('x', 64), StringComparison.Ordinal));
                break;
            default:
                File.WriteAllText(Remembered(label), "\u0001\u0002");
                break;
        }

        string again = Read(label, null).Files[1].Sha256;

        Assert.Equal(Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(image))), again);
        Assert.Contains(again, File.ReadAllText(Remembered(label)), StringComparison.Ordinal);
    }

    [Fact]
    public void Read_ChecksumsThatCannotBeStored_Warns()
    {
        string label = Large();
        Directory.CreateDirectory(Remembered(label));

        (IReadOnlyList<InputFile> files, string? warning) = Read(label, null);

        Assert.Equal(Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(_folder["LDEM_1.IMG"]))), files[1].Sha256);
        Assert.EndsWith("The model's checksums are computed anew in each run.", warning, StringComparison.Ordinal);
    }

    [Fact]
    public void Open_ChecksumsInTheCache_AreUsed()
    {
        string label = Large();
        Read(label, null);
        string cached = LdemSet.Join([LdemLabelReader.ReadFile(label)]).PlacesOf(".checksums", _folder["cache"]).Cached!;
        Directory.CreateDirectory(_folder["cache"]);
        File.Move(Remembered(label), cached);

        Assert.Equal(new FileInfo(label).Length, Open(label, _folder["cache"]).BytesToRead);
        Assert.Equal(new FileInfo(label).Length + LargeImage, Open(label, null).BytesToRead);
    }

    [Fact]
    public void Read_Cancelled_Stops()
    {
        string label = Large();

        Assert.ThrowsAny<OperationCanceledException>(() => Open(label, null).Read(new CancellationToken(canceled: true)));
        Assert.False(File.Exists(Remembered(label)));
    }

    private static LdemChecksums Open(string label, string? cache) =>
        LdemChecksums.Open(LdemSet.Join([LdemLabelReader.ReadFile(label)]), cache);

    private static (IReadOnlyList<InputFile> Files, string? Warning) Read(string label, string? cache) =>
        Open(label, cache).Read(CancellationToken.None);

    private static string Remembered(string label) => Path.ChangeExtension(label, ".checksums");

    private string Large()
    {
        byte[] samples = new byte[LargeImage];
        new Random(20120222).NextBytes(samples);
        return TestModel.Write(_folder.Path, TestModel.Label, samples);
    }
}
