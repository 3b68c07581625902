using System.Globalization;
using System.Security.Cryptography;
using System.Text;

namespace Msisf.Adapters.Terrain;

/// <summary>What tells one elevation model from another and from an older one under the same name.</summary>
/// <param name="ProductId">From the label.</param>
/// <param name="PixelsPerDegree">From the label.</param>
/// <param name="ImageBytes">Size of the image file.</param>
/// <param name="ImageWritten">When the image file was last written.</param>
/// <param name="LabelText">The whole label.</param>
public sealed record SummarySource(string ProductId, int PixelsPerDegree, long ImageBytes, DateTimeOffset ImageWritten, string LabelText)
{
    /// <summary>32 bytes that differ when any of it differs.</summary>
    internal byte[] Fingerprint() => SHA256.HashData(Encoding.UTF8.GetBytes(string.Create(
        CultureInfo.InvariantCulture,
        $"{ProductId}\n{PixelsPerDegree}\n{ImageBytes}\n{ImageWritten.UtcTicks}\n{LabelText}")));
}
