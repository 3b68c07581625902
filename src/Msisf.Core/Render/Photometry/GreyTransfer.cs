namespace Msisf.Core.Render.Photometry;

/// <summary>How an image's numbers follow from linear light.</summary>
public enum GreyTransfer
{
    /// <summary>The curve of sRGB (IEC 61966-2-1), which POV-Ray's PNG has too: for screens.</summary>
    Srgb = 0,

    /// <summary>In proportion: for measuring.</summary>
    Linear = 1,
}
