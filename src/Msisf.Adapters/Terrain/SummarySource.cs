using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using Msisf.Core.Errors;

namespace Msisf.Adapters.Terrain;

/// <summary>What tells one elevation model from another and from an older one under the same name.</summary>
/// <param name="ProductId">From the label.</param>
/// <param name="PixelsPerDegree">From the label.</param>
/// <param name="ImageBytes">Size of the image file.</param>
/// <param name="ImageWritten">When the image file was last written.</param>
/// <param name="LabelText">The whole label.</param>
public sealed record SummarySource(string ProductId, int PixelsPerDegree, long ImageBytes, DateTimeOffset ImageWritten, string LabelText)
{
    /// <summary>A label is a few kB; of an image with an attached one, more need not be read.</summary>
    private const int LongestLabel = 65536;

    /// <summary>The source that a label describes, as its files are now.</summary>
    /// <exception cref="ExternalPartException">They can't be read.</exception>
    public static SummarySource Of(LdemLabel label)
    {
        try
        {
            FileInfo image = new(label.ImagePath);
            using FileStream stream = File.OpenRead(label.LabelPath);
            byte[] text = new byte[Math.Min(LongestLabel, stream.Length)];
            stream.ReadExactly(text);
            return new SummarySource(
                label.ProductId, label.PixelsPerDegree, image.Length, image.LastWriteTimeUtc, Encoding.Latin1.GetString(text));
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            throw new ExternalPartException($"{label.LabelPath}: can't be read: {exception.Message}", exception);
        }
    }

    /// <summary>32 bytes that differ when any of it differs.</summary>
    internal byte[] Fingerprint() => SHA256.HashData(Encoding.UTF8.GetBytes(string.Create(
        CultureInfo.InvariantCulture,
        $"{ProductId}\n{PixelsPerDegree}\n{ImageBytes}\n{ImageWritten.UtcTicks}\n{LabelText}")));
}
