namespace Msisf.Core.Parallel;

/// <summary>
/// How much of a buffer the last frames have used. A buffer that grows along an orbit would otherwise keep for ever the size that
/// the frame with the most facets or shadows needed.
/// </summary>
internal sealed class RecentUse
{
    /// <summary>Frames that must all have used little before a buffer is made smaller, so that it is not soon made larger again.</summary>
    public const int Frames = 16;

    /// <summary>Elements that are always kept: less memory is not worth the work.</summary>
    public const int AlwaysKept = 4096;

    private int _frames;
    private int _most;

    /// <summary>Notes what a frame has used.</summary>
    /// <param name="used">Number of elements that the frame used.</param>
    /// <param name="length">The buffer's number of elements, which is replaced by a smaller one, or left.</param>
    /// <returns>Whether the buffer is to be made smaller.</returns>
    public bool Note(int used, ref int length)
    {
        _most = Math.Max(_most, used);
        if (++_frames < Frames)
        {
            return false;
        }

        int wanted = Math.Max(AlwaysKept, WithReserve(_most));
        (_frames, _most) = (0, 0);
        if (length / 2 < wanted)
        {
            return false;
        }

        length = wanted;
        return true;
    }

    /// <summary>A length with which a buffer that grows frame by frame is seldom replaced.</summary>
    public static int WithReserve(int used) => used + (used / 4);
}
