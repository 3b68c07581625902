namespace Msisf.Adapters.IO;

/// <summary>Tells a lock that another process holds from other file errors.</summary>
internal static class FileLock
{
    private const int LinuxWouldBlock = 11;
    private const int MacWouldBlock = 35;
    private const int WindowsSharingViolation = unchecked((int)0x80070020);
    private const int WindowsLockViolation = unchecked((int)0x80070021);

    /// <summary>Whether opening or locking failed because another process has the lock.</summary>
    public static bool IsHeldByAnother(Exception exception) => exception is IOException
        && exception.HResult is (LinuxWouldBlock or MacWouldBlock or WindowsSharingViolation or WindowsLockViolation);
}
