"""What people look at: trees and progress lines as text."""
