using System.Security.Cryptography;
using System.Text;
using Msisf.Adapters.Raster.Pds;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>Tells one elevation model from another, and from an older one of the same name.</summary>
/// <param name="ProductId">From the label.</param>
/// <param name="PixelsPerDegree">From the label.</param>
/// <param name="ImageBytes">Size of the image file; of a split product all of them.</param>
/// <param name="ImageWritten">When the image file was last written; of a split product the last of them.</param>
/// <param name="LabelText">The whole label; of a split product name, size, time and label of each part.</param>
public sealed record ModelSource(string ProductId, int PixelsPerDegree, long ImageBytes, DateTimeOffset ImageWritten, string LabelText)
{
    /// <summary>Bytes. A label has a few kB; of a file with an attached label no more is read.</summary>
    internal const int LongestLabel = 65536;

    /// <summary>The source that a model's labels describe, as its files are now.</summary>
    /// <exception cref="ExternalPartException">They can't be read.</exception>
    public static ModelSource Of(LdemSet set)
    {
        ModelSource[] parts = [.. set.Parts.Select(Of)];
        return parts.Length == 1 ? parts[0] : new ModelSource(
            set.ProductId,
            set.PixelsPerDegree,
            parts.Sum(part => part.ImageBytes),
            parts.Max(part => part.ImageWritten),
            string.Concat(parts.Select(part => part.Text())));
    }

    /// <summary>The source that a label describes, as its files are now.</summary>
    /// <exception cref="ExternalPartException">They can't be read.</exception>
    public static ModelSource Of(LdemLabel label) => FileErrors.ToExternalPart($"{label.LabelPath}: can't be read", () =>
    {
        FileInfo image = new(FileNames.FindIgnoringCase(label.ImagePath) ?? label.ImagePath);
        using FileStream stream = File.OpenRead(label.LabelPath);
        return new ModelSource(
            label.ProductId, label.PixelsPerDegree, image.Length, image.LastWriteTimeUtc, PdsLabelParser.TextOf(stream, LongestLabel));
    });

    /// <summary>A hash of 32 bytes of all of it.</summary>
    internal byte[] Fingerprint() => SHA256.HashData(Encoding.UTF8.GetBytes(Text()));

    private string Text() => Invariant(
        $"{ProductId}\n{PixelsPerDegree}\n{ImageBytes}\n{ImageWritten.UtcTicks}\n{LabelText}");
}
